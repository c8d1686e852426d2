#include "app/gui/plots/scene_module.h"

#include "app/gui/plots/vtk_messages.h"

#include <QCoreApplication>
#include <QFile>
#include <QLibrary>

namespace straightedge::gui {

QStringList sceneModuleFiles(const QString& programFolder) {
  const QString name = QStringLiteral("straightedge_gl.so");
  return {programFolder + QLatin1Char('/') + name, programFolder + QStringLiteral("/../lib/straightedge/") + name};
}

SceneRendererOrProblem makeSceneRendererFrom(const QStringList& files) {
  QString found;
  for (const QString& file : files) {
    if (QFile::exists(file)) {
      found = file;
      break;
    }
  }
  if (found.isEmpty()) {
    return {nullptr,
            QStringLiteral("Three-dimensional pictures need the file lib/straightedge/straightedge_gl.so, which "
                           "is missing: build or install Straightedge again. Everything else works without.")};
  }
  sendVtkMessagesToLog();
  QLibrary library(found);
  library.setLoadHints(QLibrary::PreventUnloadHint); // VTK's factories point into it
  const QFunctionPointer symbol = library.resolve(sceneRendererSymbol);
  if (symbol == nullptr) {
    return {nullptr,
            QStringLiteral("Three-dimensional pictures need OpenGL, which could not be loaded: %1. On Debian, the "
                           "packages libegl1 and libgl1-mesa-dri provide it. Everything else works without.")
                .arg(library.errorString())};
  }
  const auto make = reinterpret_cast<MakeSceneRenderer>(symbol);
  std::unique_ptr<SceneRenderer> renderer(make());
  if (!renderer) {
    return {nullptr,
            QStringLiteral("Three-dimensional pictures need OpenGL 3.2 (EGL), which this computer does not offer. "
                           "On Debian, the package libgl1-mesa-dri provides it in software. Everything else works "
                           "without.")};
  }
  return {std::move(renderer), {}};
}

SceneRendererOrProblem makeSceneRenderer() {
  return makeSceneRendererFrom(sceneModuleFiles(QCoreApplication::applicationDirPath()));
}

} // namespace straightedge::gui
