#include "app/gui/shell/help_window.h"

#include <QDesktopServices>
#include <QEvent>
#include <QFile>
#include <QHBoxLayout>
#include <QListWidget>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include <array>

namespace straightedge::gui {

namespace {

struct Page {
  const char* stem;
  const char* title;
  bool below = false; ///< belongs to the page above, indented
};
constexpr std::array<Page, 26> pages{
    {{"start", QT_TRANSLATE_NOOP("HelpWindow", "Overview")},
     {"connect", QT_TRANSLATE_NOOP("HelpWindow", "1  Connect")},
     {"capture", QT_TRANSLATE_NOOP("HelpWindow", "2  Capture")},
     {"review", QT_TRANSLATE_NOOP("HelpWindow", "3  Review")},
     {"fit", QT_TRANSLATE_NOOP("HelpWindow", "4  Fit")},
     {"compare", QT_TRANSLATE_NOOP("HelpWindow", "5  Compare")},
     {"verify", QT_TRANSLATE_NOOP("HelpWindow", "6  Verify")},
     {"export", QT_TRANSLATE_NOOP("HelpWindow", "7  Export")},
     {"field", QT_TRANSLATE_NOOP("HelpWindow", "Field calibration")},
     {"field-review", QT_TRANSLATE_NOOP("HelpWindow", "Review"), true},
     {"field-fit", QT_TRANSLATE_NOOP("HelpWindow", "Fit"), true},
     {"field-compare", QT_TRANSLATE_NOOP("HelpWindow", "Compare"), true},
     {"field-verify", QT_TRANSLATE_NOOP("HelpWindow", "Verify"), true},
     {"field-export", QT_TRANSLATE_NOOP("HelpWindow", "Export"), true},
     {"field-nonlinearity", QT_TRANSLATE_NOOP("HelpWindow", "Nonlinearity"), true},
     {"field-probe-temperature", QT_TRANSLATE_NOOP("HelpWindow", "Probe temperature"), true},
     {"field-offset", QT_TRANSLATE_NOOP("HelpWindow", "Offset"), true},
     {"field-sensitivity", QT_TRANSLATE_NOOP("HelpWindow", "Sensitivity"), true},
     {"field-electronics", QT_TRANSLATE_NOOP("HelpWindow", "Electronics"), true},
     {"field-electronics-sensitivity", QT_TRANSLATE_NOOP("HelpWindow", "Electronics sensitivity"), true},
     {"field-axis-matrix", QT_TRANSLATE_NOOP("HelpWindow", "Axis matrix"), true},
     {"field-joint", QT_TRANSLATE_NOOP("HelpWindow", "All blocks together"), true},
     {"field-uncertainty", QT_TRANSLATE_NOOP("HelpWindow", "Uncertainty"), true},
     {"method", QT_TRANSLATE_NOOP("HelpWindow", "The method")},
     {"files", QT_TRANSLATE_NOOP("HelpWindow", "Files and command line")},
     {"keyboard", QT_TRANSLATE_NOOP("HelpWindow", "Keyboard")}}};

QString resourceOf(const QString& stem) { return QStringLiteral("qrc:/help/%1.html").arg(stem); }

QString stemOf(const QUrl& url) { return url.fileName().section('.', 0, 0); }

} // namespace

HelpWindow::HelpWindow(QWidget* parent)
    : QDialog(parent), m_contents(new QListWidget(this)), m_browser(new QTextBrowser(this)) {
  setObjectName("helpWindow");
  setWindowTitle(tr("Straightedge Help"));
  setModal(false);
  for (const Page& page : pages) {
    constexpr QChar emSpace(0x2003);
    auto* item = new QListWidgetItem((page.below ? QString(emSpace) : QString()) + tr(page.title), m_contents);
    item->setData(Qt::UserRole, QString(page.stem));
  }
  m_contents->setFrameShape(QFrame::NoFrame);
  m_contents->setMinimumWidth(150);
  m_contents->setSpacing(3);
  auto* rail = new QFrame(this);
  rail->setBackgroundRole(QPalette::Base);
  rail->setAutoFillBackground(true);
  auto* railLayout = new QVBoxLayout(rail);
  railLayout->setContentsMargins(10, 14, 10, 14);
  railLayout->addWidget(m_contents);
  m_browser->setFrameShape(QFrame::NoFrame);
  m_browser->setOpenLinks(false);
  m_browser->document()->setDocumentMargin(22);
  auto* splitter = new QSplitter(this);
  splitter->addWidget(rail);
  splitter->addWidget(m_browser);
  splitter->setStretchFactor(1, 1);
  splitter->setSizes({190, 650});
  splitter->setHandleWidth(1);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter);
  resize(860, 640);

  connect(m_contents, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr) {
      showPage(item->data(Qt::UserRole).toString());
    }
  });
  connect(m_browser, &QTextBrowser::anchorClicked, this, [this](const QUrl& url) {
    if (url.scheme().startsWith("http")) {
      QDesktopServices::openUrl(url);
    } else {
      showPage(stemOf(url));
    }
  });
}

void HelpWindow::showPage(const QString& page) {
  const QString stem = QFile::exists(QStringLiteral(":/help/%1.html").arg(page)) ? page : QStringLiteral("start");
  m_browser->setSource(QUrl(resourceOf(stem)));
  const QSignalBlocker quiet(m_contents);
  for (int row = 0; row < m_contents->count(); ++row) {
    if (m_contents->item(row)->data(Qt::UserRole) == stem) {
      m_contents->setCurrentRow(row);
    }
  }
}

QString HelpWindow::currentPage() const { return stemOf(m_browser->source()); }

QString HelpWindow::text() const { return m_browser->toPlainText(); }

void HelpWindow::changeEvent(QEvent* event) {
  QDialog::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && !m_browser->source().isEmpty()) {
    m_browser->reload(); // link colours are fixed when a page is loaded
  }
}

} // namespace straightedge::gui
