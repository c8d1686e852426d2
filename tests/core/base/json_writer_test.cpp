#include "core/base/json_writer.h"
#include "core/base/time_stamp.h"

#include <gtest/gtest.h>

#include <limits>

namespace straightedge {
namespace {

TEST(JsonWriter, IndentsObjectsAndKeepsCompactListsOnALine) {
  JsonWriter json;
  json.beginObject();
  json.member("a", 0.1);
  json.openList("b", true);
  json.value(1);
  json.value(-2LL);
  json.endList();
  json.openList("empty");
  json.endList();
  json.openObject("c", true);
  json.member("yes", true);
  json.key("none");
  json.null();
  json.endObject();
  json.member("nan", std::numeric_limits<double>::quiet_NaN());
  json.endObject();
  EXPECT_EQ(json.take(), "{\n  \"a\": 0.1,\n  \"b\": [1, -2],\n  \"empty\": [],\n"
                         "  \"c\": {\"yes\": true, \"none\": null},\n  \"nan\": null\n}\n");
}

TEST(JsonWriter, TextIsEscapedAndAlwaysUtf8) {
  JsonWriter json;
  json.value("a\"\\\n\x01 \xC3\xA9 \xB0 \xED\xA0\x80 \xE2\x82");
  EXPECT_EQ(json.take(), "\"a\\\"\\\\\\n\\u0001 \xC3\xA9 \xEF\xBF\xBD "
                         "\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD \xEF\xBF\xBD\xEF\xBF\xBD\"\n");
}

TEST(TimeStamp, IsIso8601InUtc) {
  EXPECT_EQ(isoUtc(std::chrono::sys_seconds(std::chrono::seconds(0))), "1970-01-01T00:00:00Z");
  EXPECT_EQ(isoUtc(std::chrono::sys_seconds(std::chrono::seconds(1709251199))), "2024-02-29T23:59:59Z");
}

} // namespace
} // namespace straightedge
