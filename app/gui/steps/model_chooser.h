// Kind, size, method and width of a model to add, with its canonical name and what it would cost.
#pragma once

#include "core/angle/model_name.h"

#include <QWidget>

#include <functional>

class QComboBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace straightedge::gui {

class ModelChooser : public QWidget {
  Q_OBJECT
public:
  /// `problemOf` says why a model cannot be added; empty where it can.
  explicit ModelChooser(std::function<QString(const angle::ModelName&)> problemOf, QWidget* parent = nullptr);

  angle::ModelName name() const;
  void setName(const angle::ModelName& name);
  void refresh(); ///< asks again whether the model can be added

signals:
  void addRequested(const straightedge::angle::ModelName& name);

private:
  void fillMethods();

  std::function<QString(const angle::ModelName&)> m_problemOf;
  QComboBox* m_kind;
  QSpinBox* m_size;
  QComboBox* m_method;
  QComboBox* m_bits;
  QLabel* m_cost;
  QPushButton* m_add;
};

} // namespace straightedge::gui
