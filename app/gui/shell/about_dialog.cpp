#include "app/gui/shell/about_dialog.h"

#include "app/gui/shell/line_icon.h"

#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace straightedge::gui {

AboutDialog::AboutDialog(QWidget* parent) : QDialog(parent) {
  setObjectName("aboutDialog");
  setWindowTitle(tr("About Straightedge"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(22, 20, 22, 16);
  layout->setSpacing(14);
  auto* top = new QHBoxLayout;
  top->setSpacing(18);
  auto* icon = new QLabel(this);
  icon->setPixmap(QIcon(":/icons/straightedge.svg").pixmap(QSize(64, 64), devicePixelRatioF()));
  top->addWidget(icon, 0, Qt::AlignTop);
  auto* text = new QLabel(tr("<h2 style='margin:0'>Straightedge</h2>"
                             "<p style='margin-top:2px'>Version %1</p>"
                             "<p>Calibrates angle sensors: from a turning shaft to a table that firmware uses.</p>"
                             "<p>Built on Qt %2, VTK, Eigen, SQLite, nlohmann-json and OpenSSL.</p>")
                              .arg(QStringLiteral(STRAIGHTEDGE_VERSION), QString::fromLatin1(qVersion())),
                          this);
  text->setWordWrap(true);
  text->setMinimumWidth(340);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  top->addWidget(text, 1);
  layout->addLayout(top);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  layout->addWidget(buttons);
}

} // namespace straightedge::gui
