// Three-dimensional figures as the bytes of PNG files, each drawn once however many files want it.
#pragma once

#include "app/gui/figures/named_figure.h"
#include "app/gui/plots/scene_painting.h"

#include <QByteArray>
#include <QHash>
#include <QString>

namespace straightedge::gui {

/// Starts OpenGL with the first picture. Any thread, one call at a time.
class ScenePictures {
public:
  /// Null where there is no OpenGL: problem() says why.
  QByteArray png(const NamedFigure& figure);
  QString problem() const { return m_artist.problem(); }

private:
  SceneArtist m_artist;
  QHash<QString, QByteArray> m_drawn; ///< by stem
};

} // namespace straightedge::gui
