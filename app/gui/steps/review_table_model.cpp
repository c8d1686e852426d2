#include "app/gui/steps/review_table_model.h"

#include "core/base/number_text.h"

#include <QColor>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>
#include <functional>

namespace straightedge::gui {

namespace {

const angle::Sweep emptySweep;

QString reviewDegrees(double deg, int decimals) {
  return std::isfinite(deg) ? QString::number(deg, 'f', decimals).replace(QLatin1Char('-'), QChar(0x2212)) : QString();
}

QString exact(double value) { return std::isfinite(value) ? QString::fromStdString(formatDouble(value)) : QString(); }

} // namespace

ReviewTableModel::ReviewTableModel(QObject* parent) : QAbstractTableModel(parent), m_sweep(&emptySweep) {}

void ReviewTableModel::setSweep(const angle::Sweep& sweep) {
  if (sweep.size() == m_rows) {
    m_sweep = &sweep;
    if (m_rows > 0) {
      emit dataChanged(index(0, 0), index(static_cast<int>(m_rows) - 1, ColumnCount - 1));
    }
    return;
  }
  beginResetModel();
  m_sweep = &sweep;
  m_rows = sweep.size();
  m_analysis.reset();
  endResetModel();
}

void ReviewTableModel::setAnalysis(std::shared_ptr<const ReviewAnalysis> analysis) {
  m_analysis = std::move(analysis);
  if (m_rows > 0) {
    emit dataChanged(index(0, Error), index(static_cast<int>(m_rows) - 1, Remark));
  }
}

const ReviewRow* ReviewTableModel::reviewed(std::size_t row) const {
  return m_analysis && m_analysis->rows.size() == m_rows ? &m_analysis->rows[row] : nullptr;
}

int ReviewTableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows);
}

int ReviewTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

Qt::ItemFlags ReviewTableModel::flags(const QModelIndex& index) const {
  const Qt::ItemFlags plain = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
  return index.column() == Row ? plain | Qt::ItemIsUserCheckable : plain;
}

QString ReviewTableModel::remark(std::size_t row) const {
  if (!m_sweep->isEnabled(row)) {
    return tr("switched off");
  }
  const ReviewRow* found = reviewed(row);
  return found != nullptr && found->outlier ? tr("outlier") : QString();
}

QString ReviewTableModel::cell(std::size_t row, int column) const {
  const ReviewRow* found = reviewed(row);
  switch (column) {
  case Row:
    return QString::number(row + 1);
  case Turn:
    return m_sweep->turn.empty() ? QString() : QString::number(m_sweep->turn[row] + 1);
  case Direction:
    return m_sweep->direction.empty() ? QString() : m_sweep->direction[row] < 0 ? tr("falling") : tr("rising");
  case Encoder:
    return reviewDegrees(m_sweep->encoderDeg[row], 4);
  case Sensor:
    return reviewDegrees(m_sweep->sensorDeg[row], 4);
  case Error:
    return found == nullptr ? QString() : reviewDegrees(found->errorDeg, 4);
  case Residual:
    return found == nullptr ? QString() : reviewDegrees(found->residualDeg, 4);
  case Remark:
    return remark(row);
  default:
    return {};
  }
}

QVariant ReviewTableModel::data(const QModelIndex& index, int role) const {
  const auto row = static_cast<std::size_t>(index.row());
  if (row >= m_rows || row >= m_sweep->size()) {
    return {};
  }
  switch (role) {
  case Qt::DisplayRole:
    return cell(row, index.column());
  case Qt::CheckStateRole:
    return index.column() == Row ? QVariant(m_sweep->isEnabled(row) ? Qt::Checked : Qt::Unchecked) : QVariant();
  case Qt::TextAlignmentRole:
    return QVariant::fromValue(index.column() == Remark || index.column() == Direction || index.column() == Row
                                   ? Qt::AlignLeft | Qt::AlignVCenter
                                   : Qt::AlignRight | Qt::AlignVCenter);
  case Qt::ForegroundRole:
    if (!m_sweep->isEnabled(row)) {
      return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
    }
    return {};
  default:
    return {};
  }
}

bool ReviewTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
  if (role != Qt::CheckStateRole || index.column() != Row || static_cast<std::size_t>(index.row()) >= m_rows) {
    return false;
  }
  emit enableRequested(static_cast<std::size_t>(index.row()), value.toInt() == Qt::Checked);
  return true;
}

QVariant ReviewTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case Row:
    return tr("Row");
  case Turn:
    return tr("Turn");
  case Direction:
    return tr("Direction");
  case Encoder:
    return tr("Encoder (°)");
  case Sensor:
    return tr("Sensor (°)");
  case Error:
    return tr("Error (°)");
  case Residual:
    return tr("Residual (°)");
  case Remark:
    return tr("Remark");
  default:
    return {};
  }
}

bool ReviewTableModel::isUniform(Column column) const {
  const std::vector<int>& values = column == Turn ? m_sweep->turn : m_sweep->direction;
  return std::ranges::adjacent_find(values, std::ranges::not_equal_to{}) == values.end();
}

QString ReviewTableModel::asText(const std::vector<std::size_t>& rows) const {
  QString text;
  for (int column = 0; column < ColumnCount; ++column) {
    text += (column > 0 ? QStringLiteral("\t") : QString()) +
            headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
  }
  for (const std::size_t row : rows) {
    const ReviewRow* found = reviewed(row);
    text += QLatin1Char('\n') + cell(row, Row) + QLatin1Char('\t') + cell(row, Turn) + QLatin1Char('\t') +
            cell(row, Direction) + QLatin1Char('\t') + exact(m_sweep->encoderDeg[row]) + QLatin1Char('\t') +
            exact(m_sweep->sensorDeg[row]) + QLatin1Char('\t') +
            (found == nullptr ? QString() : exact(found->errorDeg)) + QLatin1Char('\t') +
            (found == nullptr ? QString() : exact(found->residualDeg)) + QLatin1Char('\t') + remark(row);
  }
  return text + QLatin1Char('\n');
}

} // namespace straightedge::gui
