// A file in a list of the start page: name, where it is, and a button that takes it off the list.
#pragma once

#include <QAbstractButton>

class QToolButton;

namespace straightedge::gui {

class FileRow : public QAbstractButton {
  Q_OBJECT
public:
  /// `detail` is shown after the name, elided in its middle. A row that is not there any more is greyed.
  FileRow(const QString& name, const QString& detail, bool exists, const QString& removeTip, QWidget* parent);
  QToolButton* removeButton() const { return m_remove; }
  QSize sizeHint() const override;

signals:
  void removeRequested();

protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QString m_detail;
  bool m_exists;
  QToolButton* m_remove;
};

} // namespace straightedge::gui
