#include "app/gui/steps/comparison_table.h"

#include "app/gui/figures/figure_parts.h"
#include "core/base/number_text.h"

namespace straightedge::gui {

namespace {

QString tableNumber(double value) { return fromText(formatForPeople(value)); }

} // namespace

void ComparisonTable::setComparison(std::shared_ptr<const angle::Comparison> comparison) {
  beginResetModel();
  m_comparison = std::move(comparison);
  endResetModel();
}

const angle::ComparisonRow& ComparisonTable::row(int index) const {
  return m_comparison->rows.at(static_cast<std::size_t>(index));
}

int ComparisonTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !m_comparison ? 0 : static_cast<int>(m_comparison->rows.size());
}

int ComparisonTable::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : int{ColumnCount}; }

QVariant ComparisonTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue(Qt::AlignVCenter | (index.column() < Size ? Qt::AlignLeft : Qt::AlignRight));
  }
  const bool forSorting = role == sortRole;
  if (role != Qt::DisplayRole && !forSorting) {
    return {};
  }
  const angle::ComparisonRow& each = row(index.row());
  const auto error = [forSorting](double value) { return forSorting ? QVariant(value) : QVariant(tableNumber(value)); };
  switch (index.column()) {
  case Model:
    return modelNameText(each.name);
  case Method:
    return methodTitle(each.name.kind, each.name.method);
  case Size:
    return each.name.size;
  case Entries:
    return each.storageEntries;
  case Bytes:
    return each.bytes;
  case Maximum:
    return error(each.maxErrorDeg);
  case Rms:
    return error(each.rmsErrorDeg);
  case MaximumFine:
    return each.maxErrorFineDeg ? error(*each.maxErrorFineDeg) : QVariant();
  default:
    return {};
  }
}

QVariant ComparisonTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) {
    return {};
  }
  if (role == Qt::TextAlignmentRole) {
    return QVariant::fromValue(Qt::AlignVCenter | (section < Size ? Qt::AlignLeft : Qt::AlignRight));
  }
  if (role == Qt::ToolTipRole && section == MaximumFine) {
    return tr("On 65,536 angles; the grid of 4096 flatters tables of more than 256 entries");
  }
  if (role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case Model:
    return tr("Model");
  case Method:
    return tr("Method");
  case Size:
    return tr("Size");
  case Entries:
    return tr("Entries");
  case Bytes:
    return tr("Bytes");
  case Maximum:
    return tr("Maximum (°)");
  case Rms:
    return tr("Rms (°)");
  case MaximumFine:
    return tr("Maximum, fine (°)");
  default:
    return {};
  }
}

ComparisonFilter::ComparisonFilter(QObject* parent) : QSortFilterProxyModel(parent) {
  setSortRole(ComparisonTable::sortRole);
}

void ComparisonFilter::setMethod(std::optional<std::pair<angle::ModelKind, angle::FitMethod>> method) {
  m_method = method;
  invalidateFilter();
}

void ComparisonFilter::setPowersOnly(bool on) {
  m_powersOnly = on;
  invalidateFilter();
}

QString ComparisonFilter::text(const QList<int>& rows) const {
  QStringList cells;
  for (int c = 0; c < columnCount(); ++c) {
    cells << headerData(c, Qt::Horizontal, Qt::DisplayRole).toString();
  }
  QString text = cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
  const qsizetype count = rows.isEmpty() ? rowCount() : rows.size();
  for (qsizetype i = 0; i < count; ++i) {
    cells.clear();
    for (int c = 0; c < columnCount(); ++c) {
      cells << index(rows.isEmpty() ? static_cast<int>(i) : rows[i], c).data().toString();
    }
    text += cells.join(QLatin1Char('\t')) + QLatin1Char('\n');
  }
  return text;
}

bool ComparisonFilter::filterAcceptsRow(int row, const QModelIndex& /*parent*/) const {
  const auto* table = qobject_cast<const ComparisonTable*>(sourceModel());
  if (table == nullptr) {
    return false;
  }
  const angle::ModelName& name = table->row(row).name;
  const bool power = name.size > 0 && (name.size & (name.size - 1)) == 0;
  return (!m_powersOnly || power) && (!m_method || *m_method == std::pair(name.kind, name.method));
}

} // namespace straightedge::gui
