straightedge_add_test(NAME core_base
  SOURCES core/base/csv_table_test.cpp core/base/error_test.cpp core/base/file_output_test.cpp
    core/base/json_writer_test.cpp core/base/number_text_test.cpp core/base/sha256_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
straightedge_join_tests(core_base)
