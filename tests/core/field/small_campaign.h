// A small teslameter campaign of known truth, made row by row; tests spoil it where they need to.
#pragma once

#include "core/field/campaign.h"
#include "core/field/names.h"

#include <array>
#include <cmath>
#include <initializer_list>

namespace straightedge::testing {

using namespace field;

class SmallCampaign {
public:
  SmallCampaign() {
    campaign.name = "campaign.csv";
    for (const Axis axis : allAxes) {
      for (int field = -8; field <= 8; ++field) {
        rows(4, CampaignStep::Nonlinearity, axis, 0.25 * field, 24.0, 24.0);
      }
      for (const double field : {0.3, -0.3, 1.0, -1.0, 1.6, -1.6}) {
        for (const double warmer : {-6.0, -3.0, 0.0, 3.0, 6.0}) {
          rows(2, CampaignStep::Sensitivity, axis, field, 24.0 + warmer, 24.0);
        }
      }
      for (const double field : {0.3, -0.3, 1.6, -1.6}) {
        for (const double warmer : {-6.0, -3.0, 0.0, 3.0, 6.0}) {
          rows(2, CampaignStep::ElectronicsSensitivity, axis, field, 24.0, 24.0 + warmer);
        }
      }
      for (const double field : {-2.0, -0.7, 0.7, 2.0}) {
        for (const double warmer : {-5.0, 2.0, 5.0}) {
          rows(1, CampaignStep::Verification, axis, field, 24.0 + warmer, 24.0 - warmer);
        }
      }
    }
    for (const int direction : {1, -1, 1, -1}) {
      for (int i = -10; i <= 10; ++i) {
        rows(1, CampaignStep::ProbeTemperature, {}, 0.0, 24.0 + direction * i, 24.0);
      }
    }
    for (int i = -10; i <= 10; ++i) {
      rows(1, CampaignStep::Offset, {}, 0.0, 24.0 + i, 24.0);
      rows(1, CampaignStep::Electronics, {}, 0.0, 24.0, 24.0 + i);
    }
    for (const Orientation orientation : allOrientations) {
      for (const double field : {0.5, 1.0, 1.5}) {
        orientationRows(3, orientation, isMinus(orientation) ? -field : field);
      }
    }
  }

  Campaign campaign;

  template <typename Predicate>
  void remove(Predicate predicate) {
    std::erase_if(campaign.rows, predicate);
  }
  void removeStep(CampaignStep step) {
    remove([step](const CampaignRow& row) { return row.step == step; });
  }
  template <typename Change>
  void change(CampaignStep step, Change change) {
    for (CampaignRow& row : campaign.rows) {
      if (row.step == step) {
        change(row);
      }
    }
  }

private:
  void rows(int count, CampaignStep step, std::optional<Axis> axis, double fieldT, double probeC, double electronicsC) {
    for (int i = 0; i < count; ++i) {
      CampaignRow row;
      row.step = step;
      row.axis = axis;
      row.locked = true;
      row.referenceT = fieldT;
      row.chamberC = step == CampaignStep::ProbeTemperature ? probeC : emptyCell;
      row.pt100Ohm = 100.0 + 0.385 * probeC;
      row.electronicsC = electronicsC;
      std::array<double, 3> field{};
      if (axis) {
        field[indexOf(*axis)] = fieldT;
      }
      add(row, field, probeC - 24.0, electronicsC - 24.0);
    }
  }
  void orientationRows(int count, Orientation orientation, double alongT) {
    for (int i = 0; i < count; ++i) {
      CampaignRow row;
      row.step = CampaignStep::Orientation;
      row.orientation = orientation;
      row.locked = true;
      row.referenceT = alongT;
      std::array<double, 3> field{};
      field[indexOf(axisOf(orientation))] = alongT;
      add(row, field, 0.0, 0.0);
    }
  }
  void add(CampaignRow row, const std::array<double, 3>& field, double probeC, double electronicsC) {
    constexpr std::array<std::array<double, 3>, 3> axes = {{{1.0, 0.01, -0.02}, {0.015, 1.0, 0.01}, {0.0, -0.01, 1.0}}};
    for (std::size_t i = 0; i < 3; ++i) {
      const double along = axes[i][0] * field[0] + axes[i][1] * field[1] + axes[i][2] * field[2];
      const double shown = 0.97 * along + 0.01 * along * along * along;
      const double noise =
          1e-6 * std::sin(12.9898 * static_cast<double>(campaign.rows.size()) + static_cast<double>(i));
      row.rawT[i] = shown * (1.0 - 2e-4 * probeC - 3e-5 * electronicsC) + 2e-5 * probeC - 7e-6 * electronicsC + noise;
    }
    row.line = static_cast<std::int64_t>(campaign.rows.size()) + 2; // below the header
    campaign.rows.push_back(row);
  }
};

} // namespace straightedge::testing
