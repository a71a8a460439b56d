// Notifications to the sessions that watch a marker.
#include <gtest/gtest.h>

#include "tests/server/dispatch/local_server.h"

namespace selvage::test {
namespace {

TEST(Watchers, EachIsNotifiedOfEveryRevisionInOrder) {
  LocalServer local;
  Client other;
  (void)local.open_small();
  EXPECT_EQ(local.result("marker.watch", "{'markerId':'m1'}")["revision"], 1);
  (void)local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), other.session());
  (void)local.result("marker.apply", "{'markerId':'m1','ops':[{'op':'move','piece':'low','at':[1,0]}]}");
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  (void)local.result("marker.undo", "{'markerId':'m1'}");
  for (Client* client : {&local.client, &other}) {
    const Json applied = client->next();
    EXPECT_EQ(applied["method"], "marker.changed");
    EXPECT_FALSE(applied.contains("id"));
    EXPECT_EQ(applied["params"]["revision"], 2);
    EXPECT_EQ(applied["params"]["by"], "marker.apply");
    EXPECT_EQ(applied["params"]["placements"][0]["at"], Json::parse("[1,0]"));
    const Json moved = client->next();
    EXPECT_EQ(moved["params"]["revision"], 3);
    EXPECT_EQ(moved["params"]["by"], "motion.compact");
    EXPECT_EQ(moved["params"]["length"], 4);
    EXPECT_EQ(client->next()["params"]["by"], "marker.undo");
  }
  (void)local.result("marker.close", "{'markerId':'m1'}");
  EXPECT_EQ(other.next()["method"], "marker.closed");
  EXPECT_EQ(local.client.next()["params"]["markerId"], "m1");
}

TEST(Watchers, AreRemovedByUnwatchAndDisconnection) {
  LocalServer local;
  Client leaving;
  (void)local.open_small();
  (void)local.result("marker.watch", "{'markerId':'m1'}");
  (void)local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), leaving.session());
  leaving.disconnect();
  EXPECT_EQ(local.result("marker.unwatch", "{'markerId':'m1'}")["watched"], true);
  EXPECT_EQ(local.result("marker.unwatch", "{'markerId':'m1'}")["watched"], false);
  (void)local.result("motion.compact", "{'markerId':'m1'}");
  EXPECT_EQ(local.client.pending(), 0U);
  EXPECT_EQ(leaving.pending(), 0U);
}

TEST(Watchers, NeedAConnectionThatCanBeNotified) {
  LocalServer local;
  Client deaf{false};
  (void)local.open_small();
  const Json answer = Json::parse(local.ask(call(1, "marker.watch", R"({"markerId":"m1"})"), deaf.session()));
  EXPECT_EQ(code_of(answer), -32600);
  EXPECT_EQ(code_of(local.result("marker.watch", "{'markerId':'m9'}")), -32012);
}

}  // namespace
}  // namespace selvage::test
