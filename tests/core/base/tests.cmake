straightedge_add_test(NAME core_base
  SOURCES core/base/error_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
