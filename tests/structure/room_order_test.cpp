#include "tests/structure/room_order.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace straightedge::structure {
namespace {

namespace fs = std::filesystem;

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(RoomOrder, EveryIncludeLooksBackAlongTheRoad) {
  const fs::path root = STRAIGHTEDGE_SOURCE_DIR;
  int files = 0;
  for (const char* top : {"core", "devices", "app"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / top)) {
      const auto extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") {
        continue;
      }
      ++files;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      for (const Violation& violation : violationsIn(path, textOf(entry.path()))) {
        ADD_FAILURE() << violation.file << " includes " << violation.include << ": " << violation.why;
      }
    }
  }
  EXPECT_GT(files, 20);
}

// The check itself must be able to fail: a deliberately wrong line for every rule.
TEST(RoomOrder, WrongIncludesAreFound) {
  struct Case {
    const char* path;
    const char* line;
  };
  for (const Case& wrong : {
           Case{"core/base/a.h", "#include \"core/angle/sweep.h\""},
           Case{"core/angle/a.h", "#include \"core/export/calibration_json.h\""},
           Case{"core/angle/a.h", "#include \"core/field/campaign.h\""},
           Case{"core/session/a.cpp", "#include \"core/angle/sweep.h\""},
           Case{"core/session/a.cpp", "#include \"devices/capture/angle_capture.h\""},
           Case{"devices/simulated/a.cpp", "#include \"core/session/session.h\""},
           Case{"devices/capture/a.cpp", "#include \"app/cli/main.h\""},
           Case{"app/cli/a.cpp", "#include \"app/gui/plots/plot_spec.h\""},
           Case{"app/cli/a.cpp", "#include <QString>"},
           Case{"app/gui/figures/a.cpp", "#include <vtkChartXY.h>"},
           Case{"app/gui/figures/a.cpp", "#include \"app/gui/document/angle_document.h\""},
           Case{"app/gui/steps/a.cpp", "#include \"app/gui/field_steps/field_step_pages.h\""},
           Case{"app/gui/field_steps/a.cpp", "#include \"app/gui/shell/workspace.h\""},
           Case{"app/gui/plots/a.cpp", "#include \"core/angle/curve.h\""},
           Case{"core/angle/a.cpp", "#include <sqlite3.h>"},
           Case{"devices/instruments/a.cpp", "#include <libusb-1.0/libusb.h>"},
           Case{"devices/instruments/a.cpp", "#include <libserialport.h>"},
           Case{"core/angle/a.cpp", "#include \"curve.h\""},
           Case{"core/elsewhere/a.cpp", "#include <vector>"},
       }) {
    EXPECT_FALSE(violationsIn(wrong.path, wrong.line).empty()) << wrong.path << " " << wrong.line;
  }
}

TEST(RoomOrder, RightIncludesPass) {
  EXPECT_TRUE(violationsIn("core/angle/a.cpp", "#include \"core/angle/curve.h\"\n#include \"core/base/error.h\"\n"
                                               "#include <Eigen/Core>\n#include <vector>\n")
                  .empty());
  EXPECT_TRUE(violationsIn("app/gui/plots/a.cpp", "#include <vtkChartXY.h>\n#include <QPainter>\n").empty());
}

} // namespace
} // namespace straightedge::structure
