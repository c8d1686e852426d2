# the chain applied
straightedge_add_test(NAME core_field_chain
  SOURCES core/field/chain_test.cpp core/field/sample_chain.cpp
  LIBRARIES straightedge::core
  LABELS core)

straightedge_add_test(NAME core_field_blocks
  SOURCES core/field/block_figures_test.cpp core/field/campaign_csv_test.cpp core/field/field_fit_test.cpp
    core/field/field_refusals_test.cpp
  LIBRARIES straightedge::core
  LABELS core)

# all blocks together
straightedge_add_test(NAME core_field_joint
  SOURCES core/field/joint_fit_test.cpp core/field/sample_chain.cpp core/field/storage_test.cpp
    core/field/uncertainty_test.cpp
  LIBRARIES straightedge::core
  LABELS core)

# a campaign out of a session; the simulated teslameter makes it
straightedge_add_test(NAME core_field_session
  SOURCES core/field/session_campaign_test.cpp
  LIBRARIES straightedge::devices
  LABELS core)

# the PT100 behind a lag: the simulated teslameter knows the truth
straightedge_add_test(NAME core_field_probe_lag
  SOURCES core/field/probe_lag_test.cpp
  LIBRARIES straightedge::devices
  LABELS core)
target_compile_definitions(core_field_probe_lag PRIVATE STRAIGHTEDGE_EXAMPLES="${PROJECT_SOURCE_DIR}/resources/examples")
