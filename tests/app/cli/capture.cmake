# capture angle: included by the tests of devices
find_package(nlohmann_json 3.11 REQUIRED) # for all tests of the command line
straightedge_add_test(NAME cli_capture
  SOURCES app/cli/capture_command_test.cpp app/cli/field_capture_test.cpp
  LIBRARIES straightedge::cli_commands straightedge::devices
  LABELS cli)
straightedge_join_tests(cli_capture)
