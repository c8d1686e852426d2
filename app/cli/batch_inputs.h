// Which files a batch works on, and what their results are called.
#pragma once

#include "core/base/error.h"

#include <string>
#include <vector>

namespace straightedge::cli {

struct BatchInput {
  std::string path;
  std::string resultName; ///< "NAME.json", unlike any other's
};

struct BatchInputs {
  std::vector<BatchInput> list;
  std::vector<std::string> renamed; ///< a sentence for every result that had to be called differently
};

/// `source` is a folder (its *.csv, by name; not the summary.csv of an earlier batch into the same folder) or a list: a
/// path in a line, `#` comments, "-" for a list on standard input. A path that does not exist from here is tried from
/// the list's folder. Inputs of the same name get -2, -3, … in their order.
/// Errors (Input): not there, no inputs.
Result<BatchInputs> findBatchInputs(const std::string& source, const std::string& out);

} // namespace straightedge::cli
