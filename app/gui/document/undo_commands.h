// Every change that can be undone, as a value before and after.
#pragma once

#include <QString>
#include <QUndoCommand>

#include <functional>
#include <utility>

namespace straightedge::gui {

/// Which kinds of change merge with an equal one before: only those made by dragging or typing.
enum class UndoMerge : int { Never = -1, Choices = 1, Traceability = 2, Plan = 3 };

/// Puts `after` in place on redo and `before` on undo, through `apply`, which must outlive the undo stack. A change
/// with the same merge kind and the same text as the one before it becomes one with it, so that a drag is undone in one
/// step.
template <typename Value>
class ChangeCommand : public QUndoCommand {
public:
  ChangeCommand(const QString& text, Value before, Value after, UndoMerge merge,
                std::function<void(const Value&)> apply)
      : QUndoCommand(text), m_before(std::move(before)), m_after(std::move(after)), m_merge(merge),
        m_apply(std::move(apply)) {}

  void redo() override { m_apply(m_after); }
  void undo() override { m_apply(m_before); }
  int id() const override { return static_cast<int>(m_merge); }
  bool mergeWith(const QUndoCommand* other) override {
    // Equal ids mean the same Value, see UndoMerge.
    const auto* next = static_cast<const ChangeCommand*>(other);
    if (next->text() != text()) {
      return false;
    }
    m_after = next->m_after;
    return true;
  }

private:
  Value m_before;
  Value m_after;
  UndoMerge m_merge;
  std::function<void(const Value&)> m_apply;
};

} // namespace straightedge::gui
