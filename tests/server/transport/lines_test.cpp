// Newline-delimited JSON over a real socket.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/transport/staged_server.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;

TEST(Lines, AreDistinguishedFromHttpByTheFirstByteThatIsNotBlank) {
  StagedServer server;
  for (const auto* first : {"{\"n\":1}", "[1]", " \r\n\t\n  {\"n\":1}"}) {
    Wire wire{server.port()};
    wire.send(std::string{first} + "\n");
    const std::string text{first};
    EXPECT_EQ(wire.line(), text.substr(text.find_first_of("[{")));
  }
  Wire http{server.port()};
  http.send("\r\n" + post_request("x"));
  EXPECT_EQ(http.answer().value_or(HttpAnswer{}).status, 200);
}

TEST(Lines, MayBeSplitOverWritesOrShareOne) {
  StagedServer server;
  Wire wire{server.port()};
  for (const char byte : std::string{"{\"n\":1}\r\n"}) wire.send({&byte, 1});
  EXPECT_EQ(wire.line(), "{\"n\":1}");
  wire.send("{\"n\":2}\n\n  \n{\"n\":3}\n{\"n\":");
  EXPECT_EQ(wire.line(), "{\"n\":2}");
  EXPECT_EQ(wire.line(), "{\"n\":3}");
  wire.send("4}\n");
  EXPECT_EQ(wire.line(), "{\"n\":4}");
}

TEST(Lines, AreAnsweredInOrderOfCompletion) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send("{\"hold\":1}\n{\"hold\":2}\n{\"quick\":3}\n");
  EXPECT_EQ(wire.line(), "{\"quick\":3}");
  const HeldCall first = server.next_held();
  const HeldCall second = server.next_held();
  second.reply("two");
  EXPECT_EQ(wire.line(), "two");
  first.reply("one");
  EXPECT_EQ(wire.line(), "one");
}

TEST(Lines, NotificationsGetNoAnswer) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send("{\"silent\":1}\n{\"n\":2}\n");
  EXPECT_EQ(wire.line(), "{\"n\":2}");
}

TEST(Lines, ALineBeyondTheLimitIsReportedAndTheNextIsServed) {
  server::transport::access::TransportLimits limits;
  limits.body_bytes = 1000;
  StagedServer server{limits};
  Wire wire{server.port()};
  wire.send("{" + std::string(1 << 22, 'x') + "\n{\"n\":1}\n");
  EXPECT_EQ(wire.line(), "too long");
  EXPECT_EQ(wire.line(), "{\"n\":1}");
}

TEST(Lines, AHalfClosedConnectionStillGetsAllItsAnswers) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send("{\"hold\":1}\n{\"hold\":2}\n{\"last\":\"without an end\"}");
  wire.half_close();
  EXPECT_EQ(wire.line(), "{\"last\":\"without an end\"}");
  const HeldCall first = server.next_held();
  const HeldCall second = server.next_held();
  EXPECT_FALSE(first.caller.stop_requested());
  first.reply("one");
  EXPECT_EQ(wire.line(), "one");
  second.reply("two");
  EXPECT_EQ(wire.rest(), "two\n");
}

TEST(Lines, ABrokenConnectionStopsItsCalls) {
  StagedServer server;
  for (const bool half_closed_before : {false, true}) {
    Wire wire{server.port()};
    wire.send("{\"hold\":1}\n{\"hold\":2}\n");
    const HeldCall first = server.next_held();
    const HeldCall second = server.next_held();
    if (half_closed_before) wire.half_close();
    wire.reset();
    EXPECT_TRUE(stops(first.caller));
    EXPECT_TRUE(stops(second.caller));
    first.reply("nobody reads this");
    second.reply("nor this");
  }
  EXPECT_TRUE(Wire{server.port()}.post("{}"));
}

TEST(Lines, AreNotReadWhileTooManyCallsAreInProgress) {
  server::transport::access::TransportLimits limits;
  limits.calls_per_connection = 3;
  StagedServer server{limits};
  Wire wire{server.port()};
  std::string all;
  for (int i = 0; i < 10; ++i) all += "{\"hold\":" + std::to_string(i) + "}\n";
  wire.send(all);
  std::vector<HeldCall> held;
  for (int i = 0; i < 3; ++i) held.push_back(server.next_held());
  ASSERT_TRUE(Wire{server.port()}.post("{}"));  // the I/O thread has handled everything,
  EXPECT_EQ(server.held(), 0U);                 // but not accepted the fourth call
  for (int i = 0; i < 10; ++i) {
    held[static_cast<std::size_t>(i)].reply(std::to_string(i));
    EXPECT_EQ(wire.line(), std::to_string(i));
    if (i < 7) held.push_back(server.next_held());
  }
}

TEST(Lines, AnUnfinishedLineIsDisconnectedButASilentConnectionIsNot) {
  server::transport::access::TransportLimits limits;
  limits.request = 50ms;
  StagedServer server{limits};
  Wire silent{server.port()};
  silent.send("{\"n\":1}\n");
  EXPECT_EQ(silent.line(), "{\"n\":1}");
  Wire slow{server.port()};
  slow.send("{\"n\":");
  EXPECT_EQ(slow.rest(), "");  // disconnected, after the time of `request`
  silent.send("{\"n\":2}\n");
  EXPECT_EQ(silent.line(), "{\"n\":2}");
}

TEST(Lines, TheTimeInWhichALineWaitsForEarlierCallsIsNotLimited) {
  server::transport::access::TransportLimits limits;
  limits.request = 1s;
  limits.calls_per_connection = 1;
  StagedServer server{limits};
  Wire wire{server.port()};
  wire.send("{\"n\":");
  ASSERT_TRUE(Wire{server.port()}.post("{}"));  // the I/O thread has seen that a line has begun
  wire.send("0}\n{\"hold\":1}\n{\"n\":2}\n");
  EXPECT_EQ(wire.line(), "{\"n\":0}");
  const HeldCall held = server.next_held();
  std::this_thread::sleep_for(limits.request + 500ms);
  held.reply("done");
  EXPECT_EQ(wire.line(), "done");
  EXPECT_EQ(wire.line(), "{\"n\":2}");
}

TEST(Lines, AnswersOfAnySizeAreWholeLines) {
  StagedServer server;
  Wire wire{server.port()};
  std::set<std::string> sent;
  for (const std::size_t size : {1U, 1000U, 100'000U, 3'000'000U}) {
    sent.insert("{\"" + std::string(size, 'a') + "\":0}");
  }
  for (const std::string& text : sent) wire.send(text + "\n");
  std::set<std::string> received;
  for (std::size_t i = 0; i < sent.size(); ++i) received.insert(wire.line().value_or(""));
  EXPECT_EQ(received, sent);
}

TEST(LinesDrain, AnswersCallsInProgressAndReadsNothingMore) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send("{\"hold\":1}\n");
  const HeldCall held = server.next_held();
  server.transport().stop_reading();
  EXPECT_THROW(
      {
        for (;;) Wire{server.port()};  // until the listener is closed, which is done on the I/O thread
      },
      std::system_error);
  held.reply("done");
  server.transport().finish(kPatience);
  EXPECT_EQ(wire.rest(), "done\n");
}

TEST(LinesDrain, FinishingIsLimitedWhenAClientDoesNotReadItsAnswer) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send("{\"hold\":1}\n");
  server.next_held().reply(std::string(64 << 20, 'x'));
  const auto begin = std::chrono::steady_clock::now();
  server.transport().finish(50ms);
  const auto elapsed = std::chrono::steady_clock::now() - begin;
  EXPECT_GE(elapsed, 50ms);       // the answer does not fit into the socket's buffers, so that it waits its full time
  EXPECT_LT(elapsed, kPatience);  // but no longer, although the client reads nothing
  EXPECT_EQ(server.counts().lines, 0U);
  EXPECT_LT(wire.rest().size(), std::size_t{64} << 20);  // the connection was closed before everything was sent
}

}  // namespace
}  // namespace selvage::test
