// The help pages, in the program: contents at the left, the page at the right.
#pragma once

#include <QDialog>

class QListWidget;
class QTextBrowser;

namespace straightedge::gui {

class HelpWindow : public QDialog {
  Q_OBJECT
public:
  explicit HelpWindow(QWidget* parent = nullptr);
  void showPage(const QString& page); ///< file stem in resources/help; the contents page where there is none
  QString currentPage() const;
  QString text() const; ///< of the page, plain: for tests

protected:
  void changeEvent(QEvent* event) override;

private:
  QListWidget* m_contents;
  QTextBrowser* m_browser;
};

} // namespace straightedge::gui
