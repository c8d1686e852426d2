#include "app/gui/figures/field_words.h"

#include "core/field/block_names.h"
#include "core/field/names.h"

#include <string_view>

namespace straightedge::gui {

namespace {

QString spoken(std::string_view name) {
  return QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size()))
      .replace(QLatin1Char('-'), QLatin1Char(' '));
}

QString capitalised(QString text) {
  text[0] = text[0].toUpper();
  return text;
}

} // namespace

QString blockTitle(field::Block block) { return capitalised(spoken(field::blockName(block))); }

QString stateTitle(field::VerifiedState state) { return spoken(field::stateName(state)); }

QString stepTitle(field::CampaignStep step) { return capitalised(spoken(field::stepName(step))); }

} // namespace straightedge::gui
