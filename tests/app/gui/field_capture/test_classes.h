// The test objects of this program; main.cpp runs them one after the other.
#pragma once

#include <QObject>
#include <QString>

#include <memory>

namespace straightedge::gui {

std::unique_ptr<QObject> makeFieldBenchLinkTest();
std::unique_ptr<QObject> makeFieldPlanShapeTest();
std::unique_ptr<QObject> makeFieldCapturePresenterTest();
std::unique_ptr<QObject> makeFieldCapturePagesTest();

/// In a child process: captures into a new session at `file` until somebody kills it; says "captured" on standard
/// output once rows are committed.
int captureCampaignUntilKilled(const QString& file);

} // namespace straightedge::gui
