#include "core/angle/minimax_linear.h"

namespace straightedge::angle {

Result<MinimaxLinear> linearMinimax(const Eigen::VectorXd& /*gridDeg*/, int size, const JobControl& /*job*/) {
  return fail(ErrorKind::Usage, "linear:" + std::to_string(size) + "@minimax cannot be fitted by this version",
              "use linear:" + std::to_string(size));
}

} // namespace straightedge::angle
