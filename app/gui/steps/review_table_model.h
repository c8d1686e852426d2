// A sweep's rows as a table with a tick to switch each off. Reads straight from the sweep: 100,000 rows cost nothing.
#pragma once

#include "app/gui/steps/review_analysis.h"

#include <QAbstractTableModel>

#include <memory>
#include <vector>

namespace straightedge::gui {

class ReviewTableModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column : std::uint8_t { Row, Turn, Direction, Encoder, Sensor, Error, Residual, Remark, ColumnCount };

  explicit ReviewTableModel(QObject* parent = nullptr);

  /// The sweep must outlive the model or be replaced before it goes. The selection survives where the number of rows
  /// stays the same.
  void setSweep(const angle::Sweep& sweep);
  void setAnalysis(std::shared_ptr<const ReviewAnalysis> analysis);
  /// Turn or direction: the same in every row, hence not worth a column.
  bool isUniform(Column column) const;
  /// Header and rows, tab-separated, with every digit: for the clipboard.
  QString asText(const std::vector<std::size_t>& rows) const;

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  bool setData(const QModelIndex& index, const QVariant& value, int role) override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
  void enableRequested(std::size_t row, bool enabled); ///< the tick was clicked

private:
  const ReviewRow* reviewed(std::size_t row) const;
  QString remark(std::size_t row) const;
  QString cell(std::size_t row, int column) const;

  const angle::Sweep* m_sweep;
  std::size_t m_rows = 0; ///< as announced to the views
  std::shared_ptr<const ReviewAnalysis> m_analysis;
};

} // namespace straightedge::gui
