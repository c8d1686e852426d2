# Without Qt, so that it is part of the thread sanitizer's suite, where the window is not built.
straightedge_add_test(NAME gui_job_pool
  SOURCES app/gui/jobs/job_pool_test.cpp ${PROJECT_SOURCE_DIR}/app/gui/jobs/job_pool.cpp
  LIBRARIES Threads::Threads
  LABELS gui threads)
