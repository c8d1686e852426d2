straightedge_add_test(NAME structure
  SOURCES structure/room_order.cpp structure/room_order_test.cpp
  LABELS structure)
straightedge_join_tests(structure)
target_compile_definitions(structure PRIVATE STRAIGHTEDGE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
