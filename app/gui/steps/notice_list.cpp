#include "app/gui/steps/notice_list.h"

#include "app/gui/steps/step_colors.h"

#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>

namespace straightedge::gui {

namespace {

constexpr int edgeWidth = 4;

StepColor colorOf(Notice::Level level) {
  switch (level) {
  case Notice::Level::Information:
    return StepColor::Sensor;
  case Notice::Level::Warning:
    return StepColor::Warning;
  case Notice::Level::Problem:
    return StepColor::Bad;
  }
  return StepColor::Quiet;
}

/// One notice: a label on a tinted ground with an edge. Painted, so that it follows a change of theme.
class NoticeLabel : public QLabel {
public:
  NoticeLabel(const Notice& notice, QWidget* parent) : QLabel(notice.text, parent), m_level(notice.level) {
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setTextInteractionFlags(Qt::TextSelectableByMouse);
    setContentsMargins(edgeWidth + 8, 6, 8, 6);
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    policy.setHeightForWidth(true); // as high as the wrapped text needs, no higher
    setSizePolicy(policy);
  }

protected:
  void paintEvent(QPaintEvent* event) override {
    QPainter painter(this);
    const QColor color = stepColor(*this, colorOf(m_level));
    QColor ground = color;
    ground.setAlpha(28);
    painter.fillRect(rect(), ground);
    painter.fillRect(QRect(0, 0, edgeWidth, height()), color);
    painter.end();
    QLabel::paintEvent(event);
  }

private:
  Notice::Level m_level;
};

} // namespace

NoticeList::NoticeList(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(4);
  setVisible(false);
}

void NoticeList::setNotices(const QList<Notice>& notices) {
  if (notices == m_notices) {
    return;
  }
  m_notices = notices;
  while (QLayoutItem* item = m_layout->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (const Notice& notice : notices) {
    m_layout->addWidget(new NoticeLabel(notice, this));
  }
  setVisible(!notices.isEmpty());
}

} // namespace straightedge::gui
