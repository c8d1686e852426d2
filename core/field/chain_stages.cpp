#include "core/field/chain_stages.h"

#include "core/field/names.h"
#include "core/numerics/polynomial.h"

namespace straightedge::field {

using numerics::polynomialAt;

namespace {

Eigen::VectorXd zeroWhereUnknown(const Eigen::VectorXd& values) {
  return values.array().isNaN().select(Eigen::ArrayXd::Zero(values.size()), values.array());
}

} // namespace

Eigen::VectorXd probeTemperatureC(const CorrectionChain& chain, const StepRows& rows) {
  if (!chain.pt100) {
    return Eigen::VectorXd::Zero(rows.size());
  }
  return zeroWhereUnknown(rows.pt100Ohm.array() * chain.pt100->slopeCPerOhm + chain.pt100->interceptC);
}

Eigen::VectorXd electronicsTemperatureC(const CorrectionChain& chain, const StepRows& rows) {
  return zeroWhereUnknown(rows.electronicsC.array() - chain.referenceTemperatureC);
}

Eigen::VectorXd axisValuesT(const CorrectionChain& chain, Axis axis, const StepRows& rows, ChainStage stage) {
  const AxisChain& blocks = chain.axes[indexOf(axis)];
  Eigen::VectorXd value = rows.rawT.col(static_cast<Eigen::Index>(indexOf(axis)));
  if (stage >= ChainStage::Nonlinearity && !blocks.nonlinearity.empty()) {
    value = polynomialAt(blocks.nonlinearity, value);
  }
  if (stage >= ChainStage::Offset && blocks.offsetT) {
    value -= polynomialAt(*blocks.offsetT, probeTemperatureC(chain, rows));
  }
  if (stage >= ChainStage::Sensitivity && blocks.sensitivitySlope) {
    const Eigen::VectorXd slope = polynomialAt(*blocks.sensitivitySlope, value);
    const Eigen::VectorXd intercept = blocks.sensitivityIntercept ? polynomialAt(*blocks.sensitivityIntercept, value)
                                                                  : Eigen::VectorXd::Zero(value.size());
    value.array() -= slope.array() * probeTemperatureC(chain, rows).array() + intercept.array();
  }
  if (stage >= ChainStage::Electronics && blocks.electronicsT) {
    value -= polynomialAt(*blocks.electronicsT, electronicsTemperatureC(chain, rows));
  }
  if (stage >= ChainStage::ElectronicsSensitivity && blocks.electronicsSensitivity) {
    value.array() -=
        polynomialAt(*blocks.electronicsSensitivity, value).array() * electronicsTemperatureC(chain, rows).array();
  }
  return value;
}

} // namespace straightedge::field
