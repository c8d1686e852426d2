#include "app/gui/plots/scene_spec.h"

#include <QStringList>

namespace straightedge::gui {

namespace {

QString inWords(const SurfaceSpec& spec) {
  return QStringLiteral("Surface of %1 over %2 and %3").arg(spec.zTitle, spec.xTitle, spec.yTitle);
}

QString inWords(const DirectionsSpec& spec) {
  QStringList labels;
  for (const MeasuredDirection& direction : spec.directions) {
    labels << direction.label;
  }
  return labels.join(QStringLiteral("; ")) + QStringLiteral(". ") + spec.note;
}

QString inWords(const SphereSpec& spec) {
  QStringList marks;
  for (const SphereMark& mark : spec.marks) {
    marks << mark.name + QStringLiteral(": ") + mark.detail;
  }
  return marks.join(QStringLiteral("; "));
}

} // namespace

QString sceneTitle(const SceneSpec& spec) {
  return std::visit([](const auto& each) { return each.title; }, spec);
}

QString sceneInWords(const SceneSpec& spec) {
  return std::visit([](const auto& each) { return inWords(each); }, spec);
}

bool isEmptyScene(const SceneSpec& spec) {
  return std::visit([](const auto& each) { return each.isEmpty(); }, spec);
}

} // namespace straightedge::gui
