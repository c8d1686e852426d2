// Draws the pictures of one SceneView in a thread of its own, so that the window never waits for OpenGL.
#pragma once

#include "app/gui/plots/scene_painting.h"

#include <QString>

#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

class QObject;

namespace straightedge::gui {

/// Made and used by the window's thread. The thread starts with the first request and loads OpenGL there.
class SceneWorker {
public:
  struct Drawn {
    QImage image;    ///< null: could not be drawn
    QString problem; ///< why there is no OpenGL; empty where there is
  };
  using Deliver = std::function<void(const Drawn&)>;

  /// Answers are delivered in the thread of `receiver`, which outlives this.
  explicit SceneWorker(QObject& receiver) : m_receiver(receiver) {}
  ~SceneWorker(); ///< waits for the picture in hand; what is not delivered by then never is
  SceneWorker(const SceneWorker&) = delete;
  SceneWorker& operator=(const SceneWorker&) = delete;

  /// What the view shows: a newer wish takes the place of one that is still waiting.
  void show(const SceneSpec& spec, const ScenePicture& picture, Deliver deliver);
  /// A picture that is drawn whatever else is wished: for a file or the clipboard.
  void draw(const SceneSpec& spec, const ScenePicture& picture, Deliver deliver);

private:
  struct Wish {
    SceneSpec spec;
    ScenePicture picture;
    Deliver deliver;
  };
  void wake();
  void run(const std::stop_token& stop);

  QObject& m_receiver;
  std::shared_ptr<bool> m_alive = std::make_shared<bool>(true); ///< read and written by the receiver's thread only
  std::mutex m_mutex;
  std::condition_variable_any m_changed;
  std::optional<Wish> m_shown;
  std::deque<Wish> m_drawn;
  std::jthread m_thread; // last: stops first
};

} // namespace straightedge::gui
