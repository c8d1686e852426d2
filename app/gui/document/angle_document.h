// The open angle calibration as the window sees it: sweep, choices and what was computed from them.
#pragma once

#include "app/gui/document/calibration_document.h"
#include "core/angle/calibration.h"
#include "core/angle/comparison.h"
#include "core/angle/verification.h"
#include "devices/capture/angle_plan.h"

#include <memory>
#include <optional>
#include <vector>

namespace straightedge::gui {

class JobRunner;

/// What the engineer chose; every change goes through the undo stack and into the session.
struct AngleChoices {
  angle::CurveMethod curveMethod = angle::CurveMethod::Auto;
  std::vector<angle::ModelName> models = angle::defaultModels(); ///< shown in Fit, written by Export
  angle::ModelName selected = angle::defaultModels().front();    ///< the one that Verify uses and Compare highlights
  double targetErrorDeg = 0.5;
  int budgetEntries = 64;
  std::optional<int> bits; ///< quantisation in Compare
  double limitDeg = 1.0;   ///< Verify

  bool operator==(const AngleChoices&) const = default;
};

/// GUI thread. Recomputes in jobs: sweep or choices change -> calibrate -> compare (quick, then fully); each result
/// arrives with its signal. While a job runs the previous results stay visible.
class AngleDocument : public CalibrationDocument {
  Q_OBJECT
public:
  explicit AngleDocument(JobRunner& jobs, QObject* parent = nullptr);
  ~AngleDocument() override;

  session::SessionKind kind() const override { return session::SessionKind::Angle; }

  // Sweep
  const angle::Sweep& sweep() const;                          ///< the calibration sweep; empty where there is none yet
  void setSweep(angle::Sweep sweep, const QString& undoText); ///< imported data replace the sweep (undoable)
  void reloadSweepFromSession(); ///< after capture: samples -> sweep (latest attempt of every point)
  void setPointsEnabled(const std::vector<std::size_t>& rows, bool enabled); ///< undoable
  const angle::Sweep& verificationSweep() const;
  void setVerificationSweep(angle::Sweep sweep);

  // Choices
  const AngleChoices& choices() const;
  void setChoices(const AngleChoices& choices,
                  const QString& undoText); ///< undoable; equal text in a row merges (drags)
  const devices::AnglePlan& plan() const;
  void setPlan(const devices::AnglePlan& plan); ///< undoable

  // Results: null or empty until computed, and while the data are refused
  std::shared_ptr<const angle::CalibrationRun> run() const;
  const std::optional<Error>& runError() const; ///< why the sweep was refused
  std::shared_ptr<const angle::Comparison> comparison() const;
  bool comparisonComplete() const; ///< minimax and fine grid are in
  const std::optional<angle::VerificationReport>& verification() const;
  const std::optional<Error>& verificationError() const;

signals:
  void sweepChanged();
  void choicesChanged();
  void planChanged();
  void runChanged();
  void comparisonChanged();
  void verificationSweepChanged();
  void verificationChanged();

protected:
  QStringList load(session::Session& session) override;
  void reset() override;
  bool holdsContent() const override;
  void inputsChanged() override;

private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

} // namespace straightedge::gui
