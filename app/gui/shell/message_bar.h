// One line across the top of the page for what went wrong or was noticed; never blocks the work.
#pragma once

#include <QFrame>

#include <cstdint>

class QLabel;

namespace straightedge::gui {

class MessageBar : public QFrame {
  Q_OBJECT
public:
  enum class Kind : std::uint8_t { Information, Problem };

  explicit MessageBar(QWidget* parent = nullptr);
  void showMessage(const QString& text, Kind kind);
  void dismiss();
  QString text() const;

protected:
  void changeEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

private:
  QLabel* m_text;
  Kind m_kind = Kind::Problem;
};

} // namespace straightedge::gui
