straightedge_add_test(NAME core_numerics
  SOURCES
    core/numerics/periodic_spline_test.cpp
    core/numerics/statistics_test.cpp
    core/numerics/trigonometric_fit_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
straightedge_join_tests(core_numerics)
