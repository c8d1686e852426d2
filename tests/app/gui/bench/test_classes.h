// The test objects of this program; main.cpp runs them one after the other.
#pragma once

#include <QObject>

#include <memory>

class QApplication;

namespace straightedge::gui {

std::unique_ptr<QObject> makeBenchDraftTest();
std::unique_ptr<QObject> makeBenchPresenterTest();
std::unique_ptr<QObject> makeBenchPanelTest();
std::unique_ptr<QObject> makeBenchWindowTest();

/// Writes pictures of the step Connect with emulated instruments into `folder`, light and dark; for the eye.
int takeBenchPictures(QApplication& application, const QString& folder);

} // namespace straightedge::gui
