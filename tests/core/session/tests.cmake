straightedge_add_test(NAME core_session
  SOURCES
    core/session/damage_test.cpp
    core/session/field_samples_test.cpp
    core/session/migration_test.cpp
    core/session/session_test.cpp
    core/session/storage_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
straightedge_join_tests(core_session core/session/session_test.cpp)

straightedge_add_test(NAME core_session_threads
  SOURCES core/session/committing_sink_test.cpp
  LIBRARIES straightedge::core
  LABELS core threads)
