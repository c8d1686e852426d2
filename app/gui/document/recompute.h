// Sweep and choices in, calibration, comparison and verification out: each in a job, stale results dropped.
#pragma once

#include "app/gui/document/angle_document.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <optional>

namespace straightedge::gui {

/// What the results depend on. Sweeps are shared and never changed, so that a job may read them while the window goes
/// on.
struct RecomputeInputs {
  std::shared_ptr<const angle::Sweep> sweep;
  std::shared_ptr<const angle::Sweep> verificationSweep;
  AngleChoices choices;
  Traceability traceability;
  std::string fileName; ///< of the session: the source of a captured sweep
};

/// GUI thread. Changes that come in one turn of the event loop are answered once.
class Recompute : public QObject {
  Q_OBJECT
public:
  explicit Recompute(JobRunner& jobs, QObject* parent = nullptr);
  ~Recompute() override;

  void setInputs(RecomputeInputs inputs);
  void clear(); ///< another calibration: forget everything

  std::shared_ptr<const angle::CalibrationRun> run;
  std::optional<Error> runError;
  std::shared_ptr<const angle::Comparison> comparison;
  bool comparisonComplete = false;
  std::optional<angle::VerificationReport> verification;
  std::optional<Error> verificationError;

signals:
  void runChanged();
  void comparisonChanged();
  void verificationChanged();

private:
  /// What the comparison was made from: it need not be made again when only the chosen models change.
  struct ComparisonKey {
    std::shared_ptr<const angle::Sweep> sweep;
    angle::CurveMethod method = angle::CurveMethod::Auto;
    std::optional<int> bits;
    bool operator==(const ComparisonKey&) const = default;
  };

  void start();
  void calibrate();
  void takeRun(Result<std::shared_ptr<const angle::CalibrationRun>> result);
  void compare();
  void compareRest();
  void verifyFreshSweep();
  void dropRun(std::optional<Error> why);
  void dropVerification();

  JobRunner& m_jobs;
  QTimer m_soon;
  RecomputeInputs m_inputs;
  std::optional<ComparisonKey> m_compared;
  bool m_runStale = false;
  bool m_verificationStale = false;
};

} // namespace straightedge::gui
