straightedge_add_test(NAME core_export
  SOURCES core/angle/sweep_csv_test.cpp core/export/calibration_json_test.cpp
    core/export/field_calibration_json_test.cpp core/export/tables_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
straightedge_join_tests(core_export
  core/export/field_calibration_json_test.cpp core/export/tables_test.cpp)
