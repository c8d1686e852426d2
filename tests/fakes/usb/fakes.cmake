# Emulated USB devices under the real libusb, and tests that run with umockdev's preload.
find_package(PkgConfig REQUIRED)
pkg_check_modules(UMOCKDEV IMPORTED_TARGET umockdev-1.0>=0.17)
if(NOT TARGET PkgConfig::UMOCKDEV)
  message(FATAL_ERROR "umockdev is missing: run installer/install-dependencies test (package libumockdev-dev), or configure with -DSTRAIGHTEDGE_TESTS=OFF")
endif()

add_library(emulated_usb STATIC
  fakes/usb/byte_stream_devices.cpp
  fakes/usb/emulated_device.cpp
  fakes/usb/emulated_usb.cpp
  fakes/usb/host_controller.cpp
  fakes/usb/usbtmc_device.cpp
  fakes/usb/usbtmc_device_control.cpp
)
target_link_libraries(emulated_usb PUBLIC straightedge::build_flags PkgConfig::UMOCKDEV)
target_compile_options(emulated_usb PRIVATE ${STRAIGHTEDGE_TEST_OPTIONS})
straightedge_join_tests(emulated_usb)

# GCC's sanitizer is a library that has to come before umockdev's in the list; Clang's is in the program.
set(STRAIGHTEDGE_USB_PRELOAD libumockdev-preload.so.0)
if(STRAIGHTEDGE_SANITIZE MATCHES "address" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=libasan.so
    OUTPUT_VARIABLE STRAIGHTEDGE_LIBASAN OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(STRAIGHTEDGE_USB_PRELOAD "${STRAIGHTEDGE_LIBASAN}:libumockdev-preload.so.0")
endif()

# straightedge_add_usb_test(NAME … SOURCES … LIBRARIES … LABELS …): as straightedge_add_test(), with the emulated bus.
function(straightedge_add_usb_test)
  cmake_parse_arguments(ARG "" "" "LIBRARIES" ${ARGN})
  straightedge_add_test(${ARG_UNPARSED_ARGUMENTS} LIBRARIES emulated_usb ${ARG_LIBRARIES}
    ENVIRONMENT "LD_PRELOAD=${STRAIGHTEDGE_USB_PRELOAD}")
endfunction()
