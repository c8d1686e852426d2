// The open calibration of any kind as the window sees it: its session file, its life, who and what it was made with,
// and undo. What is measured and computed is the derived kind's.
#pragma once

#include "core/base/traceability.h"
#include "core/session/session.h"

#include <QObject>
#include <QString>
#include <QStringList>
#include <QUndoStack>

#include <memory>

class QLockFile;

namespace straightedge::gui {

class SessionBinding;

/// GUI thread. Everything is kept in the session file as it changes; a new calibration lives in a scratch file until it
/// is saved under a name.
class CalibrationDocument : public QObject {
  Q_OBJECT
public:
  ~CalibrationDocument() override;

  virtual session::SessionKind kind() const = 0;
  /// The kind of the session, where open() of a document of that kind would take the file; nothing that is open is
  /// touched. Errors: those of open().
  static Result<session::SessionKind> probe(const QString& file);

  // Life
  Result<void> createScratch(); ///< a new, unnamed session
  /// A file of the scratch folder is recovered: it stays unnamed. Errors: those of Session::open(), another kind.
  Result<void> open(const QString& file);
  Result<void> saveAs(const QString& file);
  /// Commits and checkpoints. A scratch file with content stays and can be opened again ("keep for later"); an empty
  /// one is removed. Where something cannot be written the document stays open.
  Result<void> close();
  Result<void> abandon(); ///< closes without writing what is pending; the file stays as it is
  Result<void> discard(); ///< closes without writing what is pending; a scratch file is removed
  bool isOpen() const;
  bool isScratch() const;       ///< not saved under a name yet
  bool hasContent() const;      ///< samples, imported data, or anything chosen or undone
  bool isReadOnly() const;      ///< on read-only media: changes last only until saved elsewhere
  bool hasUnsavedState() const; ///< scratch with content, or a write still pending or failed
  QString file() const;
  QString displayName() const; ///< "Untitled" or the file's base name
  session::Session* session();
  const session::Session* session() const;

  const Traceability& traceability() const;
  void setTraceability(const Traceability& traceability); ///< undoable

  QUndoStack& undoStack();

signals:
  void opened(); ///< another calibration, or none: read everything anew
  void titleChanged();
  void traceabilityChanged();
  void storageFailed(const QString& message); ///< shown by the window; the document goes on

protected:
  explicit CalibrationDocument(QObject* parent = nullptr);

  /// Reads what the session has into the document; returns what could not be read, in sentences. Whatever the document
  /// held before is gone afterwards.
  virtual QStringList load(session::Session& session) = 0;
  virtual void reset() = 0;              ///< as if nothing had ever been open; session and undo are the base's
  virtual bool holdsContent() const = 0; ///< beside what can be undone
  virtual void inputsChanged() = 0;      ///< after load() and a change of traceability: compute anew

  SessionBinding& binding();
  const SessionBinding& binding() const;
  /// For the destructor of the derived kind, whose own part close() still needs.
  void endLife();

private:
  void adopt(std::unique_ptr<session::Session> session, const QString& name, std::unique_ptr<QLockFile> lock);
  void forget();
  void applyTraceability(const Traceability& value);

  struct Life;
  std::unique_ptr<Life> m_life;
};

/// The file's name without its folder, for messages and records.
std::string displayedFileName(const QString& file);

} // namespace straightedge::gui
