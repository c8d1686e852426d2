# models: fits, quantisation, comparison, recommendation
straightedge_add_test(NAME core_angle_models
  SOURCES
    core/angle/model_name_test.cpp
  LIBRARIES straightedge::core
  LABELS core)

straightedge_add_test(NAME core_angle_data
  SOURCES
    core/angle/alignment_test.cpp
    core/angle/calibration_test.cpp
    core/angle/curve_test.cpp
    core/angle/refusals_test.cpp
    core/angle/repeatability_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
