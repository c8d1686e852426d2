#include "app/gui/bench/dialogue_model.h"

#include "app/gui/bench/bench_colors.h"

#include <QDateTime>
#include <QFontDatabase>
#include <QGuiApplication>

#include <algorithm>

namespace straightedge::gui {

namespace {

using Mark = devices::DialogueMark;

/// Longer exchanges are cut for the eye; a saved file has them whole.
constexpr qsizetype mostShown = 400;

bool isFault(Mark mark) {
  return mark == Mark::SendingFailed || mark == Mark::ReceivingFailed || mark == Mark::ClearingFailed ||
         mark == Mark::StatusFailed;
}

QString directionText(Mark mark) {
  switch (mark) {
  case Mark::Sent:
    return DialogueModel::tr("→ sent");
  case Mark::Received:
    return DialogueModel::tr("← received");
  case Mark::Cleared:
    return DialogueModel::tr("cleared");
  case Mark::Status:
    return DialogueModel::tr("← status");
  case Mark::SendingFailed:
    return DialogueModel::tr("→ failed");
  case Mark::ReceivingFailed:
    return DialogueModel::tr("← failed");
  case Mark::ClearingFailed:
    return DialogueModel::tr("clearing failed");
  case Mark::StatusFailed:
    return DialogueModel::tr("status failed");
  }
  return {};
}

QString bytesText(const DialogueLog::Entry& entry) {
  if (isFault(entry.entry.mark)) {
    return QString::fromStdString(entry.entry.fault.error.what);
  }
  return QString::fromStdString(devices::escaped(entry.entry.bytes));
}

} // namespace

DialogueModel::DialogueModel(const DialogueLog& log, QObject* parent) : QAbstractTableModel(parent), m_log(log) {}

bool DialogueModel::passes(const DialogueLog::Entry& entry) const {
  return (!m_instrument || entry.instrument == *m_instrument) &&
         (m_text.isEmpty() || bytesText(entry).contains(m_text, Qt::CaseInsensitive));
}

void DialogueModel::takeNew() {
  if (m_paused) {
    return;
  }
  DialogueLog::News news = m_log.since(m_next);
  if (news.next == m_next) {
    return;
  }
  m_next = news.next;
  m_names.clear();
  for (const std::string& name : m_log.instruments()) {
    m_names << QString::fromStdString(name);
  }
  std::erase_if(news.entries, [this](const DialogueLog::Entry& entry) { return !passes(entry); });
  const auto total = m_rows.size() + news.entries.size();
  if (total > DialogueLog::mostEntries && !m_rows.empty()) {
    const auto leaving = std::min(m_rows.size(), total - DialogueLog::mostEntries);
    beginRemoveRows({}, 0, static_cast<int>(leaving) - 1);
    m_rows.erase(m_rows.begin(), m_rows.begin() + static_cast<std::ptrdiff_t>(leaving));
    endRemoveRows();
  }
  if (!news.entries.empty()) {
    const auto first = static_cast<int>(m_rows.size());
    beginInsertRows({}, first, first + static_cast<int>(news.entries.size()) - 1);
    std::ranges::move(news.entries, std::back_inserter(m_rows));
    endInsertRows();
  }
}

void DialogueModel::rebuild() {
  beginResetModel();
  m_rows.clear();
  m_next = 0;
  endResetModel();
  const bool paused = std::exchange(m_paused, false);
  takeNew();
  m_paused = paused;
}

void DialogueModel::setInstrument(std::optional<std::size_t> instrument) {
  m_instrument = instrument;
  rebuild();
}

void DialogueModel::setText(const QString& text) {
  m_text = text;
  rebuild();
}

int DialogueModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
}

int DialogueModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : ColumnCount; }

QString DialogueModel::cell(const DialogueLog::Entry& entry, int column) const {
  switch (column) {
  case Time: {
    const auto ms = std::chrono::duration_cast<std::chrono::milliseconds>(entry.when.time_since_epoch()).count();
    return QDateTime::fromMSecsSinceEpoch(ms).toString(QStringLiteral("HH:mm:ss.zzz"));
  }
  case Instrument:
    return m_names.value(static_cast<qsizetype>(entry.instrument));
  case Direction:
    return directionText(entry.entry.mark);
  case Bytes: {
    const QString bytes = bytesText(entry);
    return bytes.size() > mostShown ? bytes.left(mostShown) + QChar(0x2026) : bytes;
  }
  default:
    return {};
  }
}

QVariant DialogueModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) {
    return {};
  }
  const DialogueLog::Entry& entry = m_rows[static_cast<std::size_t>(index.row())];
  if (role == Qt::DisplayRole) {
    return cell(entry, index.column());
  }
  if (role == Qt::FontRole && (index.column() == Bytes || index.column() == Time)) {
    QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    fixed.setPointSizeF(QGuiApplication::font().pointSizeF());
    return fixed;
  }
  if (role == Qt::ForegroundRole && isFault(entry.entry.mark)) {
    return faultColor(QGuiApplication::palette());
  }
  if (role == Qt::ForegroundRole && entry.entry.mark == Mark::Sent) {
    return QGuiApplication::palette().color(QPalette::Link);
  }
  if (role == Qt::ToolTipRole && index.column() == Bytes && isFault(entry.entry.mark)) {
    return QString::fromStdString(entry.entry.fault.error.message());
  }
  return {};
}

QVariant DialogueModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) {
    return {};
  }
  switch (section) {
  case Time:
    return tr("Time");
  case Instrument:
    return tr("Instrument");
  case Direction:
    return tr("Direction");
  case Bytes:
    return tr("Bytes");
  default:
    return {};
  }
}

QString DialogueModel::text() const {
  QString all = QStringList{tr("Time"), tr("Instrument"), tr("Direction"), tr("Bytes")}.join(QLatin1Char('\t'));
  for (const DialogueLog::Entry& entry : m_rows) {
    all += QLatin1Char('\n');
    for (int column = 0; column < ColumnCount; ++column) {
      all += (column > 0 ? QStringLiteral("\t") : QString()) + cell(entry, column);
    }
  }
  return all;
}

} // namespace straightedge::gui
