// A field calibration as CSV tables for firmware and spreadsheets. Numbers read back to the same doubles.
#pragma once

#include "core/field/calibration.h"

#include <string>
#include <vector>

namespace straightedge::exporting {

/// Every coefficient in one table: `block,axis,name,power,value,unit`, in the chain's order; blocks that are off are
/// left out. `name` is the key of calibration.json; `power` that of the block's argument (ohms, tesla or °C), for
/// axis_matrix the package axis 0 to 2. `unit` is that of the value: `T/C/T^2` is tesla per °C per tesla squared.
std::string fieldCoefficientsCsv(const field::FieldCalibration& calibration);

struct NamedTable {
  std::string fileName; ///< "sensitivity.csv"
  std::string text;
};

/// A table per block that is on: a row per axis, a column per coefficient in ascending powers
/// (`axis,slope_0,…,intercept_0,…`; pt100.csv: `slope_C_per_ohm,intercept_C`; axis-matrix.csv: `axis,x,y,z`).
/// Beside them nonlinearity-orders.csv and verification.csv where the calibration has them.
std::vector<NamedTable> fieldBlockTables(const field::FieldCalibration& calibration);

/// `axis,order,max_error_percent,cross_validated_max_percent,cross_validated_rms_percent`, a row per axis and order.
std::string ordersCsv(const field::FieldCalibration& calibration);

/// `axis,state,mean_percent,sigma_percent,peak_percent,mean_percent_of_reading,…,points`, a row per axis and state.
std::string fieldVerificationCsv(const field::FieldCalibration& calibration);

} // namespace straightedge::exporting
