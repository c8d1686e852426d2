# capture angle: included by the tests of devices, because it needs nothing of the other commands
find_package(nlohmann_json 3.11 REQUIRED)
straightedge_add_test(NAME cli_capture
  SOURCES
    app/cli/capture_command_test.cpp
    ../app/cli/capture_command.cpp
    ../app/cli/capture_run.cpp
    ../app/cli/capture_watch.cpp
  LIBRARIES straightedge::core straightedge::devices nlohmann_json::nlohmann_json
  LABELS cli)
