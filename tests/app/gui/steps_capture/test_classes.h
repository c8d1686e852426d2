// The test objects of this program; main.cpp runs them one after the other.
#pragma once

#include <QObject>

#include <memory>

namespace straightedge::gui {

std::unique_ptr<QObject> makeBenchLinkTest();
std::unique_ptr<QObject> makeConnectPresenterTest();
std::unique_ptr<QObject> makeCapturePresenterTest();
std::unique_ptr<QObject> makeLiveTraceTest();
std::unique_ptr<QObject> makeReviewTest();
std::unique_ptr<QObject> makeStepPagesTest();

/// In a child process: captures into a new session at `file` until somebody kills it; says "captured" on standard
/// output once samples are committed.
int captureUntilKilled(const QString& file);

} // namespace straightedge::gui
