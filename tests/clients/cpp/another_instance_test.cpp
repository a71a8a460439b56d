// Reconnecting to a daemon that was started again without its markers, whose ids now name other markers.
#include <gtest/gtest.h>

#include <future>
#include <string>

#include "tests/clients/cpp/staged_daemon.h"

namespace selvage::test {
namespace {

constexpr std::chrono::seconds kPatience{30};

void expect_unknown(Call call) {
  const Answer answer = call.answer.get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kUnknownMarker);
}

TEST(AnotherInstance, AnUnansweredCallOnALostMarkerIsNotSentToIt) {
  StagedDaemon server;
  Client client{server.address()};
  Call lost = client.begin("motion.compact", {{"markerId", "m1"}});
  server.accept();
  EXPECT_EQ(server.receive()["method"], "motion.compact");
  Call open = client.begin("marker.open", {{"marker", "pieces"}});
  EXPECT_EQ(server.receive()["method"], "marker.open");
  server.disconnect();
  server.accept("second");
  EXPECT_EQ(server.receive()["method"], "marker.open");
  expect_unknown(std::move(lost));
}

TEST(AnotherInstance, AnIdIsUsedAgainOnlyOnceItIsTold) {
  StagedDaemon server;
  Client client{server.address()};
  for (const char* instance : {"first", "second"}) {
    Call open = client.begin("marker.open", {{"marker", "pieces"}});
    server.accept(instance);
    server.answer(server.receive()["id"], {{"markerId", "m1"}});
    ASSERT_TRUE(open.answer.get());
    Call call = client.begin("marker.check", {{"markerId", "m1"}});
    const Json received = server.receive();
    EXPECT_EQ(received["method"], "marker.check");
    server.answer(received["id"], "checked");
    EXPECT_TRUE(call.answer.get());
    server.disconnect();
  }
  Call list = client.begin("marker.list");
  server.accept("third");
  const Json listed = server.receive();
  EXPECT_EQ(listed["method"], "marker.list");
  expect_unknown(client.begin("marker.check", {{"markerId", "m1"}}));
  server.answer(listed["id"], {{"markers", {{{"markerId", "m1"}}}}});
  ASSERT_TRUE(list.answer.get());
  Call check = client.begin("marker.check", {{"markerId", "m1"}});
  EXPECT_EQ(server.receive()["method"], "marker.check");
}

TEST(AnotherInstance, AnIdThatWasLearntElsewhereIsUsed) {
  StagedDaemon server;
  Client client{server.address()};
  Call before = client.begin("marker.check", {{"markerId", "m1"}});
  server.accept();
  EXPECT_EQ(server.receive()["method"], "marker.check");
  server.disconnect();
  server.accept_only();
  const Json asked = server.receive();
  EXPECT_EQ(asked["method"], "engine.info");
  Call learnt = client.learn_marker("m1");
  Call after = client.begin("motion.compact", {{"markerId", "m1"}});
  Call list = client.begin("marker.list");
  server.answer(asked["id"], {{"instance", "second"}});
  expect_unknown(std::move(before));
  const Answer known = learnt.answer.get();
  EXPECT_TRUE(known && known->is_null());
  EXPECT_EQ(server.receive()["method"], "motion.compact") << "the call that began when the id was known";
}

TEST(AnotherInstance, AWatchedMarkerIsReportedAsClosed) {
  StagedDaemon server;
  std::promise<std::string> closed;
  std::promise<void> restored;
  Client client{server.address(),
                {},
                {.notified =
                     [&](std::string_view method, const Json& params) {
                       closed.set_value(std::string{method} + " " + params["markerId"].get<std::string>());
                     },
                 .reconnected = [&] { restored.set_value(); }}};
  Call watch = client.begin("marker.watch", {{"markerId", "m7"}});
  server.accept();
  server.answer(server.receive()["id"], {{"watching", true}});
  ASSERT_TRUE(watch.answer.get());
  server.disconnect();
  server.accept("second");
  auto reported = closed.get_future();
  ASSERT_EQ(reported.wait_for(kPatience), std::future_status::ready);
  EXPECT_EQ(reported.get(), "marker.closed m7");
  EXPECT_EQ(restored.get_future().wait_for(kPatience), std::future_status::ready);
  Call list = client.begin("marker.list");
  EXPECT_EQ(server.receive()["method"], "marker.list") << "the watch is not restored";
}

TEST(AnotherInstance, ALiveDaemonsOtherMarkerIsNotTakenForTheLostOne) {
  LiveDaemon daemon;
  const Json document{{"marker", garment("jeans_02g")}};
  Client client{daemon.socket()};
  ASSERT_TRUE(client.call("marker.open", document));
  daemon.kill();
  daemon.start();
  Client other{daemon.socket()};
  ASSERT_EQ((*other.call("marker.open", document))["markerId"], "m1");
  expect_unknown(client.begin("motion.compact", {{"markerId", "m1"}}));
  EXPECT_EQ((*other.call("marker.check", {{"markerId", "m1"}}))["revision"], 1);
}

}  // namespace
}  // namespace selvage::test
