straightedge_add_test(NAME core_sweep_files
  SOURCES core/angle/sweep_csv_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
