#include "app/gui/field_steps/field_page_figures.h"

#include "app/gui/document/field_document.h"

#include <algorithm>

namespace straightedge::gui {

std::shared_ptr<const FieldResults> resultsOf(const FieldDocument& document) {
  if (!document.run()) {
    return nullptr;
  }
  auto results = std::make_shared<FieldResults>();
  results->run = document.run();
  results->calibration = results->run->result;
  results->campaign = document.sharedCampaign();
  results->comparison = document.comparisonIsCurrent() ? document.comparison() : nullptr;
  results->verification = document.verification();
  results->verificationIsFresh = document.verificationIsFresh();
  return results;
}

QList<NamedFigure> figuresAbout(const FieldDocument& document, std::span<const FigureTopic> topics) {
  QList<NamedFigure> figures;
  if (const auto results = resultsOf(document)) {
    figures = fieldFigures(results);
    figures.removeIf(
        [topics](const NamedFigure& figure) { return std::ranges::find(topics, figure.topic) == topics.end(); });
  }
  return figures;
}

QString shortName(const NamedFigure& figure) {
  QString text = figure.stem;
  for (const char* axis : {"-x", "-y", "-z"}) {
    if (text.endsWith(QLatin1String(axis))) {
      text.replace(text.size() - 2, 1, QStringLiteral(", "));
    }
  }
  text.replace(QLatin1Char('-'), QLatin1Char(' '));
  if (!text.isEmpty()) {
    text[0] = text[0].toUpper();
  }
  return text;
}

int placeOf(const QList<NamedFigure>& figures, const QString& stem) {
  for (int i = 0; i < figures.size(); ++i) {
    if (figures[i].stem == stem) {
      return i;
    }
  }
  return figures.isEmpty() ? -1 : 0;
}

} // namespace straightedge::gui
