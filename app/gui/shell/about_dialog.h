// Name, version, what it is built on.
#pragma once

#include <QDialog>

namespace straightedge::gui {

class AboutDialog : public QDialog {
  Q_OBJECT
public:
  explicit AboutDialog(QWidget* parent = nullptr);
};

} // namespace straightedge::gui
