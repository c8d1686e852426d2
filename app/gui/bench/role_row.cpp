#include "app/gui/bench/role_row.h"

#include "app/gui/bench/bench_colors.h"
#include "app/gui/bench/device_list.h"
#include "app/gui/bench/tinted_label.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFontDatabase>
#include <QGridLayout>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QSignalBlocker>
#include <QToolButton>

namespace straightedge::gui {

namespace {

QComboBox* narrowCombo(QWidget* parent, const QString& name) {
  auto* box = new QComboBox(parent);
  box->setObjectName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(12);
  return box;
}

} // namespace

RoleRow::RoleRow(const RoleSlot& slot, QWidget* parent) : QFrame(parent), m_role(slot.role), m_value(new QLabel(this)) {
  const QString word = QString::fromUtf8(devices::roleWord(slot.role).data(),
                                         static_cast<qsizetype>(devices::roleWord(slot.role).size()));
  setObjectName(QStringLiteral("role-") + word);
  setAcceptDrops(true);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(10, 8, 10, 8);
  layout->setVerticalSpacing(4);
  auto* title = new QLabel(slot.title, this);
  QFont bold = title->font();
  bold.setBold(true);
  title->setFont(bold);
  QFont figures = QFontDatabase::systemFont(QFontDatabase::FixedFont);
  figures.setPointSizeF(font().pointSizeF());
  m_value->setFont(figures);
  m_value->setObjectName(QStringLiteral("value-") + word);
  m_value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* top = new QHBoxLayout;
  top->setSpacing(8);
  top->addWidget(title);
  if (!slot.needed) {
    auto* optional = new TintedLabel(quietColor, this);
    optional->setWordWrap(false);
    optional->setText(tr("optional"));
    top->addWidget(optional);
  }
  top->addStretch(1);
  top->addWidget(m_value);
  layout->addLayout(top, 0, 0, 1, 3);

  m_device = narrowCombo(this, QStringLiteral("device-") + word);
  m_device->setAccessibleName(tr("Device for: %1").arg(slot.title));
  m_device->setToolTip(tr("Choose a device, or drag one here from the list"));
  m_instrument = narrowCombo(this, QStringLiteral("instrument-") + word);
  m_instrument->setAccessibleName(tr("Instrument behind the device for: %1").arg(slot.title));
  m_instrument->setToolTip(tr("The device does not say what is connected to it"));
  m_settings = new QToolButton(this);
  m_settings->setObjectName(QStringLiteral("settings-") + word);
  m_settings->setText(tr("Settings…"));
  m_settings->setFocusPolicy(Qt::TabFocus);
  layout->addWidget(m_device, 1, 0, 1, 2);
  layout->addWidget(m_settings, 1, 2);
  layout->addWidget(m_instrument, 2, 0, 1, 3);
  m_caution = new TintedLabel(warningColor, this);
  m_caution->setObjectName(QStringLiteral("caution-") + word);
  m_fault = new TintedLabel(faultColor, this);
  m_fault->setObjectName(QStringLiteral("fault-") + word);
  layout->addWidget(m_caution, 3, 0, 1, 3);
  layout->addWidget(m_fault, 4, 0, 1, 3);
  layout->setColumnStretch(0, 1);

  connect(m_device, &QComboBox::activated, this,
          [this](int index) { emit deviceChosen(m_device->itemData(index).toInt()); });
  connect(m_instrument, &QComboBox::activated, this, &RoleRow::instrumentChosen);
  connect(m_settings, &QToolButton::clicked, this, &RoleRow::settingsWanted);
}

void RoleRow::showRole(const BenchPresenter::RoleView& view, bool mayEdit) {
  const QSignalBlocker quietDevice(m_device);
  const QSignalBlocker quietInstrument(m_instrument);
  m_device->clear();
  for (const BenchPresenter::RoleChoice& choice : view.choices) {
    m_device->addItem(choice.text, choice.device);
  }
  m_device->setCurrentIndex(view.chosen);
  m_device->setToolTip(view.filled ? m_device->currentText() : tr("Choose a device, or drag one here from the list"));
  m_device->setEnabled(mayEdit);
  m_instrument->clear();
  for (const QString& instrument : view.instruments) {
    m_instrument->addItem(tr("Read as: %1").arg(instrument));
  }
  m_instrument->setCurrentIndex(view.instrument);
  m_instrument->setVisible(view.instruments.size() > 1);
  m_instrument->setEnabled(mayEdit);
  m_settings->setVisible(view.hasSettings);
  m_settings->setEnabled(mayEdit);
  m_caution->setTextOrHide(view.caution);
  showReading(view);
}

void RoleRow::showReading(const BenchPresenter::RoleView& view) {
  m_value->setText(view.value);
  if (m_fault->text() != view.fault || m_fault->isHidden() != view.fault.isEmpty()) {
    m_fault->setTextOrHide(view.fault);
  }
}

void RoleRow::setTarget(bool target) {
  m_target = target;
  update();
}

void RoleRow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasFormat(DeviceList::mimeType()) && m_device->isEnabled()) {
    event->setDropAction(Qt::CopyAction);
    event->accept();
    setTarget(true);
  }
}

void RoleRow::dragLeaveEvent(QDragLeaveEvent* event) {
  QFrame::dragLeaveEvent(event);
  setTarget(false);
}

void RoleRow::dropEvent(QDropEvent* event) {
  setTarget(false);
  event->setDropAction(Qt::CopyAction);
  event->accept();
  emit deviceDropped(QString::fromUtf8(event->mimeData()->data(DeviceList::mimeType())));
}

void RoleRow::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(palette().color(m_target ? QPalette::Highlight : QPalette::Mid), m_target ? 2.0 : 1.0));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0), 4.0, 4.0);
}

} // namespace straightedge::gui
