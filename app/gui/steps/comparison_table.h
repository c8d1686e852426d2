// Every row of a comparison, for sorting, filtering and copying.
#pragma once

#include "core/angle/comparison.h"

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>

#include <memory>
#include <optional>
#include <utility>

namespace straightedge::gui {

class ComparisonTable : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { Model, Method, Size, Entries, Bytes, Maximum, Rms, MaximumFine, ColumnCount };
  static constexpr int sortRole = Qt::UserRole; ///< numbers as numbers

  using QAbstractTableModel::QAbstractTableModel;
  void setComparison(std::shared_ptr<const angle::Comparison> comparison);
  const angle::ComparisonRow& row(int index) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
  std::shared_ptr<const angle::Comparison> m_comparison;
};

/// Rows of one method, or all; sizes that are powers of two, or all.
class ComparisonFilter : public QSortFilterProxyModel {
  Q_OBJECT
public:
  explicit ComparisonFilter(QObject* parent = nullptr);
  void setMethod(std::optional<std::pair<angle::ModelKind, angle::FitMethod>> method);
  void setPowersOnly(bool on);
  /// Rows as shown, tab-separated with a header; only `rows` where the list is not empty.
  QString text(const QList<int>& rows = {}) const;

protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

private:
  std::optional<std::pair<angle::ModelKind, angle::FitMethod>> m_method;
  bool m_powersOnly = true;
};

} // namespace straightedge::gui
