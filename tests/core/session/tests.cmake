straightedge_add_test(NAME core_session
  SOURCES core/session/session_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
