// Reading and listing markers.
#include <gtest/gtest.h>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

TEST(MarkerMethods, SinceReturnsOnlyThePiecesThatMoved) {
  LocalServer local;
  (void)local.open_small();
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[1,0]}]}");
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'high','at':[1,4]}]}");
  const Json last = local.result("marker.get", "{'markerId':'m1','since':2}");
  EXPECT_FALSE(last.contains("marker"));
  ASSERT_EQ(last["placements"].size(), 1U);
  EXPECT_EQ(last["placements"][0]["id"], "high");
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m1','since':1}")["placements"].size(), 2U);
  EXPECT_EQ(local.result("marker.get", "{'markerId':'m1','since':3}")["placements"].size(), 0U);
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'setSpacing','spacing':1}]}");
  EXPECT_TRUE(local.result("marker.get", "{'markerId':'m1','since':3}").contains("marker"));  // more than moves
  EXPECT_TRUE(local.result("marker.get", "{'markerId':'m1','since':99}").contains("marker"));
}

TEST(MarkerMethods, GetNotesWhatAFormatLoses) {
  LocalServer local;
  const std::string unplaced = R"("unplaced":[{"id":"left","shape":"square"}])";
  std::string marker = kSmallMarker;
  marker.insert(marker.size() - 1, "," + unplaced);
  ASSERT_EQ(local.ask_json(call(1, "marker.open", R"({"marker":)" + marker + "}"))["result"]["unplaced"], 1);
  const Json lossy = local.result("marker.get", "{'markerId':'m1','format':'dxf'}");
  ASSERT_EQ(lossy["notes"].size(), 1U);
  EXPECT_EQ(lossy["notes"][0]["field"], "");
  EXPECT_EQ(lossy["notes"][0]["text"], "1 unplaced piece is left out; native, sparrow and esicup files list them");
  EXPECT_TRUE(lossy["marker"].is_string());
  for (const std::string format : {"native", "sparrow"}) {
    EXPECT_FALSE(local.result("marker.get", "{'markerId':'m1','format':'" + format + "'}").contains("notes")) << format;
  }
}

TEST(MarkerMethods, ListsTheOpenMarkers) {
  LocalServer local;
  EXPECT_EQ(local.result("marker.list", "{}")["markers"].size(), 0U);
  (void)local.open_small();
  (void)local.open_small();
  (void)local.result("motion.compact", "{'markerId':'m2'}");
  const Json list = local.result("marker.list", "{}")["markers"];
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[1]["markerId"], "m2");
  EXPECT_EQ(list[1]["revision"], 2);
  EXPECT_EQ(list[1]["length"], 4);
  EXPECT_EQ(list[0]["name"], "small");
}

}  // namespace
}  // namespace selvage::test
