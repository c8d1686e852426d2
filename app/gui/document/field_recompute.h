// Campaign and choices in, field calibration and verification out: each in a job, stale results dropped.
#pragma once

#include "app/gui/document/field_choices.h"
#include "core/base/error.h"
#include "core/base/traceability.h"
#include "core/field/campaign.h"
#include "core/field/field_fit.h"
#include "core/field/storage.h"
#include "core/field/verification.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace straightedge::gui {

class JobRunner;

/// What the results depend on. Shared and never changed, so that a job may read while the window goes on.
struct FieldInputs {
  std::shared_ptr<const field::Campaign> campaign;
  std::shared_ptr<const std::vector<bool>> enabled;
  std::shared_ptr<const field::Campaign> verification;
  FieldChoices choices;
  Traceability traceability;
  std::string fileName; ///< of the session: the source of a captured campaign
};

/// GUI thread. Changes that come in one turn of the event loop are answered once.
class FieldRecompute : public QObject {
  Q_OBJECT
public:
  explicit FieldRecompute(JobRunner& jobs, QObject* parent = nullptr);
  ~FieldRecompute() override;

  void setInputs(FieldInputs inputs);
  void clear(); ///< another calibration: forget everything
  void setComparisonWanted(bool wanted);

  std::shared_ptr<const field::FieldRun> run;
  std::optional<Error> runError;
  std::shared_ptr<const field::StorageComparison> comparison;
  bool comparisonIsCurrent = false; ///< made from `run`
  std::optional<field::LimitReport> verification;
  bool verificationIsFresh = false;
  std::optional<Error> verificationError;

signals:
  void runChanged();
  void comparisonChanged();
  void verificationChanged();

private:
  void start();
  void calibrate();
  void compare();
  void verify();
  void dropRun(std::optional<Error> why);
  void dropVerification();

  JobRunner& m_jobs;
  QTimer m_soon;
  FieldInputs m_inputs;
  std::shared_ptr<const field::FieldRun> m_compared; ///< what the comparison was, or is being, made from
  bool m_comparisonWanted = false;
  bool m_runStale = false;
  bool m_verificationStale = false;
};

/// The rows that count: switched on, and not of a step whose block is off.
field::Campaign countedRows(const field::Campaign& campaign, const std::vector<bool>& enabled,
                            const std::set<field::Block>& blocksOff);

} // namespace straightedge::gui
