// What the step Review of a field calibration says and does, without widgets: stages, runs, what counts, raw readings.
#pragma once

#include "app/gui/document/field_document.h"
#include "app/gui/field_steps/campaign_stages.h"
#include "app/gui/figures/sweep_figures.h"
#include "app/gui/plots/scene_spec.h"
#include "app/gui/steps/notice_list.h"

#include <QList>
#include <QObject>
#include <QString>

#include <optional>
#include <vector>

namespace straightedge::gui {

/// GUI thread. Every change goes through the document and can be undone.
class FieldReviewPresenter : public QObject {
  Q_OBJECT
public:
  struct Fact {
    QString caption, value, hint;
  };

  explicit FieldReviewPresenter(FieldDocument& document, QObject* parent = nullptr);

  bool hasCampaign() const { return !m_document.campaign().rows.empty(); }
  QString missing() const;       ///< empty once there is a campaign
  QList<Notice> notices() const; ///< the refusal first, then the warnings
  QList<Fact> facts() const;
  const std::vector<ListedStage>& stages() const;                                       ///< as of now
  std::optional<std::pair<std::size_t, std::size_t>> placeOfRow(std::size_t row) const; ///< stage and run that hold it

  std::vector<std::size_t> rowsOf(std::size_t stage, std::optional<std::size_t> run) const; ///< without a run: all
  void setEnabled(const std::vector<std::size_t>& rows, bool enabled, const QString& what = {});
  void toggle(const std::vector<std::size_t>& rows); ///< all on where any of them is off
  bool anyOff() const;
  void switchAllOn();

  /// Raw readings of a step in the order recorded.
  const PlotSpec& plot(field::CampaignStep step) const;
  std::optional<std::size_t> rowAt(int series, int index) const; ///< of the plot made last
  SphereSpec orientations() const;                               ///< directions covered by the rows that count

signals:
  void changed();

private:
  void forget();

  FieldDocument& m_document;
  mutable std::optional<std::vector<ListedStage>> m_stages;
  mutable std::optional<field::CampaignStep> m_plotted;
  mutable RowFigure m_figure;
};

} // namespace straightedge::gui
