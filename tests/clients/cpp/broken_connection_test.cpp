// Connections that break at the worst moment.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>

#include "tests/clients/cpp/staged_daemon.h"

namespace selvage::test {
namespace {

TEST(BrokenConnection, AChangeIsSentAgainWithTheSameOpId) {
  StagedDaemon server;
  Client client{server.address()};
  Call call = client.begin("motion.compact", {{"markerId", "m1"}});
  server.accept();
  const Json first = server.receive();
  EXPECT_FALSE(first["params"]["opId"].get<std::string>().empty());
  server.disconnect();
  server.accept();
  const Json second = server.receive();
  EXPECT_EQ(first, second);
  server.answer(second["id"], "done");
  const Answer answer = call.answer.get();
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, "done");
}

TEST(BrokenConnection, KeepsTheOpIdOfTheCaller) {
  StagedDaemon server;
  Client client{server.address()};
  Call call = client.begin("marker.undo", {{"markerId", "m1"}, {"opId", "mine"}});
  server.accept();
  EXPECT_EQ(server.receive()["params"]["opId"], "mine");
  Call reading = client.begin("marker.get", {{"markerId", "m1"}});
  EXPECT_FALSE(server.receive()["params"].contains("opId"));
}

TEST(BrokenConnection, ACallThatMustNotBeRepeatedIsNotSentAgain) {
  StagedDaemon server;
  Client client{server.address()};
  Call drag = client.begin("drag.move", {{"dragId", "d1"}});
  Call info = client.begin("engine.info");
  server.accept();
  EXPECT_EQ(server.receive()["method"], "drag.move");
  EXPECT_EQ(server.receive()["method"], "engine.info");
  server.disconnect();
  const Answer lost = drag.answer.get();
  ASSERT_FALSE(lost);
  EXPECT_EQ(lost.error().code, CallCode::kDisconnected);
  server.accept();
  const Json again = server.receive();
  EXPECT_EQ(again["method"], "engine.info");
  server.answer(again["id"], "info");
  EXPECT_TRUE(info.answer.get());
}

// The client watches m7, and then connects again.
void watch_and_reconnect(StagedDaemon& server, Client& client) {
  Call watch = client.begin("marker.watch", {{"markerId", "m7"}});
  server.accept();
  server.answer(server.receive()["id"], {{"watching", true}});
  ASSERT_TRUE(watch.answer.get());
  server.disconnect();
  server.accept();
}

TEST(BrokenConnection, WatchesAreRestored) {
  StagedDaemon server;
  Client client{server.address()};
  ASSERT_NO_FATAL_FAILURE(watch_and_reconnect(server, client));
  const Json again = server.receive();
  EXPECT_EQ(again["method"], "marker.watch");
  EXPECT_EQ(again["params"]["markerId"], "m7");
}

// Once the connection is reported as restored, the caller reads the marker again.  A change between that and the watch
// would be missed.
TEST(BrokenConnection, IsReportedAsRestoredOnceALoadingDaemonAcceptsTheWatches) {
  StagedDaemon server;
  std::atomic<bool> reported{};
  std::promise<void> restored;
  Handlers handlers;
  handlers.reconnected = [&] {
    reported = true;
    restored.set_value();
  };
  Client client{server.address(), {}, handlers};
  ASSERT_NO_FATAL_FAILURE(watch_and_reconnect(server, client));
  server.refuse(server.receive()["id"]);
  const Json again = server.receive();
  EXPECT_EQ(again["method"], "marker.watch");
  EXPECT_FALSE(reported);
  server.answer(again["id"], {{"watching", true}});
  EXPECT_EQ(restored.get_future().wait_for(std::chrono::seconds{30}), std::future_status::ready);
}

TEST(BrokenConnection, ACallThatALoadingDaemonRefusesIsSentAgain) {
  StagedDaemon server;
  Client client{server.address()};
  Call call = client.begin("motion.compact", {{"markerId", "m1"}});
  server.accept();
  const Json first = server.receive();
  server.disconnect();
  server.accept();
  server.refuse(server.receive()["id"]);
  const Json again = server.receive();
  EXPECT_EQ(again, first);
  server.answer(again["id"], "done");
  EXPECT_TRUE(call.answer.get());
}

TEST(BrokenConnection, ALoadingDaemonIsAskedForItsInstanceAgain) {
  StagedDaemon server;
  Client client{server.address(), {.connect_for = std::chrono::seconds{30}}};
  Call call = client.begin("motion.compact", {{"markerId", "m1"}});
  server.accept_only();
  server.refuse(server.receive()["id"]);
  const Json again = server.receive();
  EXPECT_EQ(again["method"], "engine.info");
  server.answer(again["id"], {{"instance", "first"}});
  EXPECT_EQ(server.receive()["method"], "motion.compact");
}

TEST(BrokenConnection, ACallIsAnsweredIfADaemonThatIsStillLoadingDoesNotTellItsInstance) {
  StagedDaemon server;
  Client client{server.address()};
  Call call = client.begin("marker.list");
  server.accept_only();
  server.refuse(server.receive()["id"]);
  const Answer refused = call.answer.get();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, CallCode::kBusy);
  Call next = client.begin("marker.list");
  server.answer(server.receive()["id"], {{"instance", "first"}});
  EXPECT_EQ(server.receive()["method"], "marker.list");
}

TEST(BrokenConnection, ABusyDaemonsRefusalIsReturnedOnAFirstConnection) {
  StagedDaemon server;
  Client client{server.address()};
  Call call = client.begin("engine.info");
  server.accept();
  server.refuse(server.receive()["id"]);
  const Answer answer = call.answer.get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kBusy);
}

TEST(BrokenConnection, GivesUpAfterTheTimeLimit) {
  StagedDaemon server;
  std::promise<CallError> lost;
  Client client{server.address(),
                {.reconnect_for = std::chrono::milliseconds{50}},
                {.lost = [&](const CallError& error) { lost.set_value(error); }}};
  Call call = client.begin("engine.info");
  server.accept();
  (void)server.receive();
  server.stop_listening();
  server.disconnect();
  const Answer answer = call.answer.get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kUnreachable);
  EXPECT_EQ(lost.get_future().get().code, CallCode::kUnreachable);
}

TEST(BrokenConnection, DestroyingTheClientAnswersOpenCalls) {
  StagedDaemon server;
  std::optional<Client> client{std::in_place, server.address()};
  Call call = client->begin("engine.info");
  server.accept();
  (void)server.receive();
  client.reset();
  const Answer answer = call.answer.get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kEnded);
}

}  // namespace
}  // namespace selvage::test
