// A dialogue log as a table: time, instrument, direction, bytes; filtered, and held still while it is paused.
#pragma once

#include "app/gui/bench/dialogue_log.h"

#include <QAbstractTableModel>
#include <QString>
#include <QStringList>

#include <deque>
#include <optional>

namespace straightedge::gui {

/// GUI thread; takes over what is new when it is asked to.
class DialogueModel : public QAbstractTableModel {
  Q_OBJECT
public:
  enum Column { Time, Instrument, Direction, Bytes, ColumnCount };

  explicit DialogueModel(const DialogueLog& log, QObject* parent = nullptr);

  void takeNew(); ///< nothing while paused
  void setPaused(bool paused) { m_paused = paused; }
  bool isPaused() const { return m_paused; }
  void setInstrument(std::optional<std::size_t> instrument); ///< none: all
  void setText(const QString& text);                         ///< only exchanges whose bytes contain it, in any case
  void rebuild();                                            ///< from all that the log still has

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role = Qt::DisplayRole) const override;

  QString text() const; ///< all rows, tab-separated, with titles

private:
  bool passes(const DialogueLog::Entry& entry) const;
  QString cell(const DialogueLog::Entry& entry, int column) const;

  const DialogueLog& m_log;
  QStringList m_names;
  std::deque<DialogueLog::Entry> m_rows;
  std::uint64_t m_next = 0;
  std::optional<std::size_t> m_instrument;
  QString m_text;
  bool m_paused = false;
};

} // namespace straightedge::gui
