#include "app/gui/field_steps/field_page_words.h"

#include "app/gui/figures/field_words.h"
#include "core/base/number_text.h"
#include "core/field/block_names.h"
#include "core/field/names.h"

#include <QCoreApplication>

namespace straightedge::gui {

namespace {

QString sayFieldWord(const char* text) { return QCoreApplication::translate("FieldWords", text); }

QString latin(std::string_view text) { return QString::fromLatin1(text.data(), static_cast<qsizetype>(text.size())); }

} // namespace

QString axisWord(const std::optional<field::Axis>& axis) {
  return axis ? latin(field::axisName(*axis)) : sayFieldWord("all");
}

QString stageWord(field::CampaignStep step, const std::optional<field::Axis>& axis,
                  const std::optional<field::Orientation>& orientation) {
  QString text = stepTitle(step);
  if (axis) {
    text += QStringLiteral(", ") + latin(field::axisName(*axis));
  }
  if (orientation) {
    text += QStringLiteral(", ") + withProperMinus(latin(field::orientationName(*orientation)));
  }
  return text;
}

QString withProperMinus(QString text) { return text.replace(QLatin1Char('-'), QChar(0x2212)); }

QString blockHelpPage(field::Block block) { return QStringLiteral("field-") + latin(field::blockName(block)); }

QString percentFigure(double percent) {
  constexpr int decimals = 4;
  QString text = QString::number(percent, 'f', decimals);
  if (text.toDouble() == 0.0) {
    text.remove(QLatin1Char('-')); // no minus before zeros
  }
  return withProperMinus(text);
}

QString percentPhrase(double percent) {
  return withProperMinus(QString::fromStdString(formatForPeople(percent, 3))) + QStringLiteral(" %");
}

} // namespace straightedge::gui
