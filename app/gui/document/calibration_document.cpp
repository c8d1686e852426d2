#include "app/gui/document/calibration_document.h"

#include "app/gui/document/calibration_document_state.h"
#include "app/gui/document/undo_commands.h"

#include <QFileInfo>

#include <utility>

namespace straightedge::gui {

CalibrationDocument::CalibrationDocument(QObject* parent) : QObject(parent), m_life(std::make_unique<Life>()) {
  connect(&m_life->binding, &SessionBinding::failed, this, [this](const QString& message) {
    emit titleChanged();
    emit storageFailed(message);
  });
  connect(&m_life->binding, &SessionBinding::written, this, &CalibrationDocument::titleChanged);
  connect(&m_life->undo, &QUndoStack::indexChanged, this, &CalibrationDocument::titleChanged);
}

CalibrationDocument::~CalibrationDocument() = default;

void CalibrationDocument::endLife() {
  disconnect(&m_life->undo, nullptr, this, nullptr);
  static_cast<void>(close()); // nobody is left to tell; what was committed stays in the file
}

bool CalibrationDocument::isOpen() const { return m_life->binding.session() != nullptr; }

bool CalibrationDocument::isScratch() const { return m_life->scratchLock != nullptr; }

QString CalibrationDocument::file() const { return m_life->file; }

session::Session* CalibrationDocument::session() { return m_life->binding.session(); }

const session::Session* CalibrationDocument::session() const { return m_life->binding.session(); }

const Traceability& CalibrationDocument::traceability() const { return m_life->traceability; }

QUndoStack& CalibrationDocument::undoStack() { return m_life->undo; }

SessionBinding& CalibrationDocument::binding() { return m_life->binding; }

const SessionBinding& CalibrationDocument::binding() const { return m_life->binding; }

void CalibrationDocument::adopt(std::unique_ptr<session::Session> session, const QString& name,
                                std::unique_ptr<QLockFile> lock) {
  m_life->undo.clear();
  reset();
  m_life->file = name;
  m_life->scratchLock = std::move(lock);
  m_life->binding.attach(std::move(session));
  auto& attached = *m_life->binding.session();
  QStringList problems = load(attached);
  m_life->traceability = {};
  if (auto known = attached.traceability()) {
    m_life->traceability = std::move(*known);
  } else {
    problems.append(QString::fromStdString(known.error().message()));
  }
  inputsChanged();
  emit opened();
  emit titleChanged();
  if (!problems.isEmpty()) {
    emit storageFailed(problems.join('\n'));
  }
}

void CalibrationDocument::forget() {
  m_life->undo.clear();
  m_life->traceability = {};
  m_life->file.clear();
  m_life->scratchLock.reset();
  reset();
  emit opened();
  emit titleChanged();
}

void CalibrationDocument::setTraceability(const Traceability& traceability) {
  m_life->undo.push(new ChangeCommand<Traceability>(tr("change details"), m_life->traceability, traceability,
                                                    UndoMerge::Traceability,
                                                    [this](const Traceability& value) { applyTraceability(value); }));
}

void CalibrationDocument::applyTraceability(const Traceability& value) {
  m_life->traceability = value;
  m_life->binding.schedule("traceability",
                           [value](session::Session& session) { return session.setTraceability(value); });
  inputsChanged();
  emit traceabilityChanged();
}

std::string displayedFileName(const QString& file) { return QFileInfo(file).fileName().toStdString(); }

} // namespace straightedge::gui
