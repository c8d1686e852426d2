// A large button of the start page: icon, name, one line that says what it does.
#pragma once

#include <QAbstractButton>

namespace straightedge::gui {

class ActionCard : public QAbstractButton {
  Q_OBJECT
public:
  ActionCard(const QString& icon, const QString& title, const QString& description, QWidget* parent);
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent* event) override;

private:
  QFont titleFont() const;

  QString m_icon;
  QString m_description;
};

} // namespace straightedge::gui
