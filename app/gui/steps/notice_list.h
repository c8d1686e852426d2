// Notices above or beside the work: what happened and what to do, with a coloured edge that says how serious it is.
#pragma once

#include <QList>
#include <QString>
#include <QWidget>

#include <cstdint>

class QVBoxLayout;

namespace straightedge::gui {

struct Notice {
  enum class Level : std::uint8_t { Information, Warning, Problem };
  Level level = Level::Information;
  QString text;

  bool operator==(const Notice&) const = default;
};

/// Hides itself while there is nothing to say. The text can be selected and copied.
class NoticeList : public QWidget {
  Q_OBJECT
public:
  explicit NoticeList(QWidget* parent = nullptr);
  void setNotices(const QList<Notice>& notices);
  const QList<Notice>& notices() const { return m_notices; }

private:
  QList<Notice> m_notices;
  QVBoxLayout* m_layout;
};

} // namespace straightedge::gui
