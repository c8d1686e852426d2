straightedge_add_qt_test(NAME gui_jobs
  SOURCES app/gui/jobs/job_runner_test.cpp
  LIBRARIES straightedge::window
  LABELS gui threads)
