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
