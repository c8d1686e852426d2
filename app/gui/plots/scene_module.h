// Loads the module with OpenGL when the first three-dimensional picture is wanted.
#pragma once

#include "app/gui/plots/scene_renderer.h"

#include <QString>
#include <QStringList>

#include <memory>

namespace straightedge::gui {

/// A renderer, or a sentence why there is none.
struct SceneRendererOrProblem {
  std::unique_ptr<SceneRenderer> renderer;
  QString problem;
};

/// Loads the module the first time (it stays loaded) and starts OpenGL: 0.2 s and 120 MB in software. Any thread.
SceneRendererOrProblem makeSceneRenderer();

/// Where the module is looked for, in this order: beside the program, and in lib/straightedge next to its folder.
QStringList sceneModuleFiles(const QString& programFolder);

/// The same as makeSceneRenderer() with a module of one's own choice: the first of these files that is there.
SceneRendererOrProblem makeSceneRendererFrom(const QStringList& files);

} // namespace straightedge::gui
