# Tests of the window: each folder below lists its own. Qt Test or GoogleTest, always on the offscreen platform.
# straightedge_add_qt_test(NAME gui_plot_view SOURCES … LIBRARIES … LABELS gui): one Qt Test executable, one ctest, on the
# offscreen platform: no X server, no shared pointer, any number at once.
set(STRAIGHTEDGE_QT_TEST_ENVIRONMENT QT_QPA_PLATFORM=offscreen QT_FATAL_CRITICALS=1
  QTEST_FUNCTION_TIMEOUT=${STRAIGHTEDGE_TEST_LIMIT_S}000)
find_package(Qt6 6.4 REQUIRED COMPONENTS Test Widgets)
if(STRAIGHTEDGE_JOIN_TESTS)
  straightedge_add_test_headers(qt_test_headers LIBRARIES Qt6::Test Qt6::Widgets
    HEADERS ${STRAIGHTEDGE_QT_HEADERS} <QSignalSpy> <QTest> ${PROJECT_SOURCE_DIR}/tests/app/gui/patience.h)
endif()
function(straightedge_add_qt_test)
  cmake_parse_arguments(ARG "" "NAME" "SOURCES;LIBRARIES;LABELS" ${ARGN})
  add_executable(${ARG_NAME} ${ARG_SOURCES})
  set_target_properties(${ARG_NAME} PROPERTIES AUTOMOC ON)
  target_link_libraries(${ARG_NAME} PRIVATE straightedge::build_flags Qt6::Test Qt6::Widgets ${ARG_LIBRARIES})
  target_compile_options(${ARG_NAME} PRIVATE ${STRAIGHTEDGE_TEST_OPTIONS})
  if(TARGET qt_test_headers)
    straightedge_precompile_test(${ARG_NAME} qt_test_headers)
  else()
    target_compile_options(${ARG_NAME} PRIVATE "SHELL:-include ${PROJECT_SOURCE_DIR}/tests/app/gui/patience.h")
  endif()
  target_compile_definitions(${ARG_NAME} PRIVATE
    STRAIGHTEDGE_TEST_DATA="${PROJECT_SOURCE_DIR}/tests/data"
    STRAIGHTEDGE_BINARY_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  add_test(NAME ${ARG_NAME} COMMAND ${ARG_NAME})
  set_tests_properties(${ARG_NAME} PROPERTIES
    ENVIRONMENT "${STRAIGHTEDGE_QT_TEST_ENVIRONMENT}" LABELS "${ARG_LABELS}" TIMEOUT ${STRAIGHTEDGE_TEST_LIMIT_S})
endfunction()

foreach(room plots figures document jobs shell bench steps steps_capture steps_fit field_steps field_capture window end_to_end screenshots)
  if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/app/gui/${room}/tests.cmake)
    include(app/gui/${room}/tests.cmake)
  endif()
endforeach()
