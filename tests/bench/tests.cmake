# Google Benchmark: built with -DSTRAIGHTEDGE_BENCHMARKS=ON, run by hand (release), never part of ctest.
if(STRAIGHTEDGE_BENCHMARKS)
  find_package(benchmark 1.7 REQUIRED)

  # straightedge_add_bench(NAME bench_angle_models SOURCES … LIBRARIES …): an executable per pair of files measured.
  function(straightedge_add_bench)
    cmake_parse_arguments(ARG "" "NAME" "SOURCES;LIBRARIES" ${ARGN})
    add_executable(${ARG_NAME} ${ARG_SOURCES})
    target_link_libraries(${ARG_NAME} PRIVATE straightedge::build_flags benchmark::benchmark ${ARG_LIBRARIES})
    target_compile_definitions(${ARG_NAME} PRIVATE STRAIGHTEDGE_TEST_DATA="${CMAKE_CURRENT_SOURCE_DIR}/data")
  endfunction()

  straightedge_add_bench(NAME bench_angle_models
    SOURCES bench/angle_models_bench.cpp
    LIBRARIES straightedge::core)

  straightedge_add_bench(NAME bench_field_fit
    SOURCES bench/field_fit_bench.cpp
    LIBRARIES straightedge::core)

  straightedge_add_bench(NAME bench_apply
    SOURCES bench/apply_bench.cpp bench/readings.cpp
    LIBRARIES straightedge::cli_commands)
  straightedge_add_bench(NAME bench_field_apply
    SOURCES bench/field_apply_bench.cpp core/field/sample_chain.cpp
    LIBRARIES straightedge::cli_commands)
  straightedge_add_bench(NAME bench_batch
    SOURCES bench/batch_bench.cpp bench/readings.cpp
    LIBRARIES straightedge::cli_commands)

  straightedge_add_bench(NAME bench_capture_session
    SOURCES bench/capture_session_bench.cpp
    LIBRARIES straightedge::core straightedge::devices)
  straightedge_add_bench(NAME bench_line_stream
    SOURCES bench/line_stream_bench.cpp
    LIBRARIES straightedge::devices)
  straightedge_add_bench(NAME bench_usbtmc_query # with LD_PRELOAD=libumockdev-preload.so.0
    SOURCES bench/usbtmc_query_bench.cpp
    LIBRARIES straightedge::devices emulated_usb)
  if(STRAIGHTEDGE_GUI)
    straightedge_add_bench(NAME bench_plots # with QT_QPA_PLATFORM=offscreen
      SOURCES bench/plots/plot_bench.cpp
      LIBRARIES straightedge::plots)
  endif()
endif()

# Any program's first window on an X display; tests/bench/startup compares ours with another.
find_package(X11)
if(X11_FOUND AND STRAIGHTEDGE_GUI)
  add_executable(bench_first_window bench/first_window.cpp)
  target_link_libraries(bench_first_window PRIVATE straightedge::build_flags X11::X11)
endif()

# What a live capture costs in the real window: frames a second and the processor's share.
if(STRAIGHTEDGE_BENCHMARKS AND STRAIGHTEDGE_GUI)
  add_executable(bench_live_capture bench/live_capture.cpp)
  target_link_libraries(bench_live_capture PRIVATE straightedge::window)
endif()

# The same for a board that streams over an emulated USB bus, with the share of each part; with umockdev's preload.
if(STRAIGHTEDGE_BENCHMARKS AND STRAIGHTEDGE_GUI)
  add_executable(bench_usb_stream bench/usb_stream.cpp)
  target_link_libraries(bench_usb_stream PRIVATE straightedge::window straightedge::devices emulated_usb)
endif()
