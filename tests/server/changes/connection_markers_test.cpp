// Markers that are closed when the connection that opened them ends.
#include <gtest/gtest.h>

#include <string>

#include "tests/server/dispatch/local_server.h"
#include "tests/server/store/temporary_folder.h"

namespace selvage::test {
namespace {

std::string opening(const std::string& rest = "") {
  return call(1, "marker.open", R"({"marker":)" + kSmallMarker + R"(,"closeWithConnection":true)" + rest + "}");
}
std::string opened(LocalServer& local, Client& client, const std::string& rest = "") {
  return Json::parse(local.ask(opening(rest), client.session()))["result"]["markerId"].text();
}

TEST(ConnectionMarkers, AreClosedWithTheirConnection) {
  LocalServer local;
  Client other;
  EXPECT_EQ(local.open_small(), "m1");
  EXPECT_EQ(opened(local, local.client), "m2");
  EXPECT_EQ(opened(local, other), "m3");
  (void)local.result("marker.watch", "{'markerId':'m3'}");
  other.disconnect();
  EXPECT_FALSE(local.store().is_open("m3"));
  EXPECT_EQ(local.client.next()["method"], "marker.closed");
  EXPECT_EQ(local.store().count(), 2U);
  local.client.disconnect();
  EXPECT_TRUE(local.store().is_open("m1"));
  EXPECT_FALSE(local.store().is_open("m2"));
}

TEST(ConnectionMarkers, AreClosedByAWorkerWhenThereAreAny) {
  LocalServer local{1};
  Client other;
  EXPECT_EQ(opened(local, other), "m1");
  (void)local.result("marker.watch", "{'markerId':'m1'}");
  other.disconnect();
  EXPECT_EQ(local.client.next()["method"], "marker.closed");
  EXPECT_FALSE(local.store().is_open("m1"));
}

TEST(ConnectionMarkers, MayBeClosedAndChangedBefore) {
  LocalServer local;
  Client other;
  EXPECT_EQ(opened(local, other), "m1");
  EXPECT_EQ(opened(local, other), "m2");
  EXPECT_EQ(local.result("marker.close", "{'markerId':'m1'}")["closed"], true);
  EXPECT_EQ(local.result("motion.compact", "{'markerId':'m2'}")["revision"], 2);
  other.disconnect();
  EXPECT_EQ(local.store().count(), 0U);
}

// The page may go before its call has been carried out.
TEST(ConnectionMarkers, AreNotLeftBehindByAConnectionThatHasEnded) {
  LocalServer local;
  Client other;
  other.disconnect();
  (void)local.ask(opening(), other.session());
  EXPECT_EQ(local.store().count(), 0U);
}

TEST(ConnectionMarkers, AreOpenedAnewByTheSameCallOnAnotherConnection) {
  LocalServer local;
  Client other;
  EXPECT_EQ(opened(local, other, R"(,"opId":"one")"), "m1");
  other.disconnect();
  EXPECT_EQ(opened(local, local.client, R"(,"opId":"one")"), "m2");
  EXPECT_TRUE(local.store().is_open("m2"));
}

TEST(ConnectionMarkers, AreRefusedWhereNoConnectionLasts) {
  LocalServer local;
  Client http{false};
  const Json answer = Json::parse(local.ask(opening(), http.session()));
  EXPECT_EQ(code_of(answer), -32600);
  EXPECT_EQ(answer["error"]["data"]["field"], "/closeWithConnection");
  EXPECT_EQ(local.store().count(), 0U);
}

TEST(ConnectionMarkers, ThatAKilledDaemonLeftInItsStoreAreClosedAtTheNextStart) {
  const TemporaryFolder folder;
  const auto durability = server::store::Durability::kRelaxed;
  for (int start = 0; start < 3; ++start) {
    server::store::Journal journal{folder.file("store"), durability};
    Client other;
    LocalServer local{0, pushing_methods(), {}, &journal};
    EXPECT_EQ(local.store().count(), static_cast<std::size_t>(start)) << "only those that belong to the daemon";
    (void)local.open_small();
    const std::string id = opened(local, other);
    const Json compacted = local.result("motion.compact", "{'markerId':'" + id + "'}");
    EXPECT_EQ(compacted["revision"], 2) << compacted;
  }
}

}  // namespace
}  // namespace selvage::test
