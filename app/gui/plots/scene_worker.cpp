#include "app/gui/plots/scene_worker.h"

#include "app/gui/plots/scene_module.h"

#include <QMetaObject>
#include <QObject>

#include <utility>

namespace straightedge::gui {

SceneWorker::~SceneWorker() { *m_alive = false; }

void SceneWorker::show(const SceneSpec& spec, const ScenePicture& picture, Deliver deliver) {
  {
    const std::scoped_lock lock(m_mutex);
    m_shown = Wish{spec, picture, std::move(deliver)};
  }
  wake();
}

void SceneWorker::draw(const SceneSpec& spec, const ScenePicture& picture, Deliver deliver) {
  {
    const std::scoped_lock lock(m_mutex);
    m_drawn.push_back({spec, picture, std::move(deliver)});
  }
  wake();
}

void SceneWorker::wake() {
  if (!m_thread.joinable()) {
    m_thread = std::jthread([this](const std::stop_token& stop) { run(stop); });
  }
  m_changed.notify_one();
}

void SceneWorker::run(const std::stop_token& stop) {
  SceneRendererOrProblem made = makeSceneRenderer();
  while (true) {
    Wish wish;
    {
      std::unique_lock lock(m_mutex);
      if (!m_changed.wait(lock, stop, [this] { return m_shown.has_value() || !m_drawn.empty(); })) {
        return;
      }
      if (m_shown) {
        wish = *std::exchange(m_shown, std::nullopt);
      } else {
        wish = std::move(m_drawn.front());
        m_drawn.pop_front();
      }
    }
    Drawn drawn;
    drawn.problem = made.problem;
    if (made.renderer) {
      drawn.image = paintScene(*made.renderer, wish.spec, wish.picture);
    }
    QMetaObject::invokeMethod(
        &m_receiver,
        [alive = m_alive, deliver = std::move(wish.deliver), drawn = std::move(drawn)] {
          if (*alive) {
            deliver(drawn);
          }
        },
        Qt::QueuedConnection);
  }
}

} // namespace straightedge::gui
