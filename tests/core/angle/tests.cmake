# models: fits, quantisation, comparison, recommendation
straightedge_add_test(NAME core_angle_models
  SOURCES
    core/angle/model_curves.cpp
    core/angle/model_name_test.cpp
    core/angle/model_fit_test.cpp
    core/angle/linear_model_test.cpp
    core/angle/lookup_table_model_test.cpp
    core/angle/minimax_linear_test.cpp
    core/angle/quantisation_test.cpp
    core/angle/comparison_test.cpp
    core/angle/recommendation_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
straightedge_join_tests(core_angle_models)

straightedge_add_test(NAME core_angle_data
  SOURCES
    core/angle/alignment_test.cpp
    core/angle/calibration_test.cpp
    core/angle/curve_test.cpp
    core/angle/refusals_test.cpp
    core/angle/repeatability_test.cpp
    core/angle/uncertainty_test.cpp
    core/angle/verification_test.cpp
  LIBRARIES straightedge::core
  LABELS core)
straightedge_join_tests(core_angle_data core/angle/curve_test.cpp)
