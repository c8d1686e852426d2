# The real program as a child process.
straightedge_add_test(NAME cli
  SOURCES app/cli/apply_command_test.cpp app/cli/batch_command_test.cpp app/cli/child_process.cpp
    app/cli/compare_export_test.cpp app/cli/exit_code_test.cpp app/cli/fit_command_test.cpp
  LIBRARIES straightedge::core nlohmann_json::nlohmann_json
  LABELS cli)
straightedge_join_tests(cli
  app/cli/compare_export_test.cpp app/cli/exit_code_test.cpp app/cli/fit_command_test.cpp)
add_dependencies(cli straightedge-cli)

straightedge_add_test(NAME cli_field
  SOURCES app/cli/child_process.cpp app/cli/field_command_test.cpp
  LIBRARIES straightedge::core nlohmann_json::nlohmann_json
  LABELS cli)
straightedge_join_tests(cli_field)
add_dependencies(cli_field straightedge-cli)

straightedge_add_test(NAME cli_threads
  SOURCES app/cli/parallel_work_test.cpp
  LIBRARIES straightedge::cli_commands
  LABELS cli threads)

straightedge_add_test(NAME cli_field_apply
  SOURCES app/cli/field_correction_test.cpp core/field/sample_chain.cpp
  LIBRARIES straightedge::cli_commands
  LABELS cli)
straightedge_join_tests(cli_field_apply)

straightedge_add_test(NAME cli_field_apply_command
  SOURCES app/cli/child_process.cpp app/cli/field_apply_command_test.cpp core/field/sample_chain.cpp
  LIBRARIES straightedge::core
  LABELS cli)
straightedge_join_tests(cli_field_apply_command)
add_dependencies(cli_field_apply_command straightedge-cli)
