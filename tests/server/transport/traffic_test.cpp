// The bytes that clients make the server hold: counted from the first byte of a request to the last of its answer, and
// limited for a connection and for all of them.
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/websocket_wire.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;
using server::transport::access::TransportLimits;

constexpr std::size_t kMessage = 100'000;

std::string held_message() {
  return R"({"hold":")" + std::string(kMessage, 'x') + "\"}";
}

// Returns false if the server still holds more bytes after a long time.
bool holds_at_most(const StagedServer& server, std::size_t bytes) {
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (server.account().held() > bytes && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  return server.account().held() <= bytes;
}

TEST(Traffic, AConnectionIsNotReadWhileItsCallsHaveTooManyBytes) {
  StagedServer server{TransportLimits{.request_bytes = 2 * kMessage}};
  Wire wire{server.port()};
  for (int k = 0; k < 4; ++k) wire.send(held_message() + "\n");
  const HeldCall first = server.next_held();
  const HeldCall second = server.next_held();
  ASSERT_TRUE(Wire{server.port()}.post("{}"));  // the I/O thread has handled everything,
  EXPECT_EQ(server.held(), 0U);                 // but not accepted the third call
  EXPECT_GE(server.account().held(), 2 * kMessage);
  first.reply("1");
  EXPECT_EQ(wire.line(), "1");
  const HeldCall third = server.next_held();
  for (const HeldCall* held : {&second, &third}) held->reply("next");
  server.next_held().reply("last");
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(wire.line());
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, ARequestThatIsLargerThanAllTheRoomIsRefused) {
  StagedServer server{TransportLimits{.traffic_bytes = kMessage, .room = 20ms}};
  Wire busy{server.port()};
  busy.send(post_request(held_message()));
  EXPECT_EQ(busy.answer().value_or(HttpAnswer{}).status, 503);  // larger than all the room there is
}

TEST(Traffic, AConnectionThatWaitsForRoomIsReadWhenThereIsSome) {
  StagedServer server{TransportLimits{.traffic_bytes = 3 * kMessage}};
  std::vector<std::unique_ptr<Wire>> wires;
  std::vector<HeldCall> held;
  for (int k = 0; k < 3; ++k) {
    wires.push_back(std::make_unique<Wire>(server.port()));
    wires.back()->send(held_message() + "\n");
    held.push_back(server.next_held());
  }
  Wire late{server.port()};
  late.send("{\"hold\":4}\n");
  Wire page{server.port()};
  page.send("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n");
  EXPECT_EQ(page.answer().value_or(HttpAnswer{}).status, 200);  // pages are always served
  EXPECT_EQ(server.held(), 0U);
  for (const HeldCall& call : held) call.reply("done");
  server.next_held().reply("late");
  EXPECT_EQ(late.line(), "late");
  for (const auto& wire : wires) EXPECT_EQ(wire->line(), "done");
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, ALineThatHasBegunIsDroppedIfThereIsNoRoomInTime) {
  StagedServer server{TransportLimits{.traffic_bytes = 2 * kMessage, .room = 20ms}};
  std::vector<std::unique_ptr<Wire>> wires;
  std::vector<HeldCall> held;
  for (int k = 0; k < 2; ++k) {
    wires.push_back(std::make_unique<Wire>(server.port()));
    wires.back()->send(held_message() + "\n");
    held.push_back(server.next_held());
  }
  // Lines that wait for their ends would otherwise block each other.
  Wire begun{server.port()};
  begun.send("{\"" + std::string(kMessage, 'x'));
  EXPECT_EQ(begun.line(), "no room");
  begun.send("\":1}\n{\"n\":2}\n");
  for (const HeldCall& call : held) call.reply("done");
  EXPECT_EQ(begun.line(), "{\"n\":2}");
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, AMessageOnAWebSocketForWhichThereIsNoRoomClosesIt) {
  StagedServer server{TransportLimits{.traffic_bytes = 3 * kMessage + 1000, .room = 20ms}};
  WebSocketWire socket{server.port()};
  Wire busy{server.port()};
  busy.send(post_request(held_message()));
  const HeldCall one = server.next_held();
  socket.send({Opcode::kText, std::string(kMessage, 'x'), false});
  Wire more{server.port()};
  more.send(post_request(held_message()));
  const HeldCall two = server.next_held();
  socket.send({Opcode::kContinuation, std::string(kMessage, 'x'), false});
  EXPECT_EQ(socket.text(), "no room");
  EXPECT_EQ(socket.frame().value_or(Frame{}).close_code(), 1013);
  one.reply("1");
  two.reply("2");
  EXPECT_TRUE(busy.answer() && more.answer());
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, AnHttpRequestForWhichThereIsNoRoomIsRefusedBeforeItsBody) {
  StagedServer server{TransportLimits{.traffic_bytes = 2 * kMessage, .room = 20ms}};
  Wire busy{server.port()};
  busy.send(post_request(held_message()));
  const HeldCall held = server.next_held();
  Wire late{server.port()};
  late.send("POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Length: " + std::to_string(kMessage) + "\r\n\r\n");
  const HttpAnswer refused = late.answer().value_or(HttpAnswer{});
  EXPECT_EQ(refused.status, 503);
  EXPECT_EQ(refused.body, "no room");
  EXPECT_TRUE(refused.says("Retry-After: 1\r\n"));
  held.reply("done");
  EXPECT_EQ(busy.answer().value_or(HttpAnswer{}).body, "done");
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, AnswersCountUntilTheyAreSent) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send("{\"hold\":1}\n");
  server.next_held().reply(std::string(64 << 20, 'x'));
  ASSERT_TRUE(Wire{server.port()}.post("{}"));
  const auto end = std::chrono::steady_clock::now() + kPatience;
  while (server.account().held() < (32 << 20) && std::chrono::steady_clock::now() < end) std::this_thread::yield();
  EXPECT_GE(server.account().held(), std::size_t{64} << 20);
  wire.close();
  EXPECT_TRUE(holds_at_most(server, 0));
}

std::string weighing(std::size_t weight, const std::string& more = "\"n\":1") {
  return "{\"weight\":" + std::to_string(weight) + "," + more + "}";
}

TEST(Traffic, TheMemoryToAnswerAMessageIsCountedAndWaitedFor) {
  StagedServer server{TransportLimits{.traffic_bytes = 3 * kMessage, .room = 600s}};
  Wire busy{server.port()};
  busy.send(weighing(2 * kMessage, "\"hold\":1") + "\n");
  const HeldCall held = server.next_held();
  EXPECT_GE(server.account().held(), 2 * kMessage);
  Wire lines{server.port()};
  lines.send(weighing(2 * kMessage) + "\n");
  Wire http{server.port()};
  http.send(post_request(weighing(2 * kMessage)));
  WebSocketWire socket{server.port()};
  socket.send_text(weighing(2 * kMessage));
  Wire small{server.port()};
  small.send("{\"n\":2}\n");
  EXPECT_EQ(small.line(), "{\"n\":2}");  // there is room for a small one
  held.reply("done");
  EXPECT_EQ(busy.line(), "done");
  EXPECT_EQ(lines.line(), weighing(2 * kMessage));
  EXPECT_EQ(http.answer().value_or(HttpAnswer{}).body, weighing(2 * kMessage));
  EXPECT_EQ(socket.text(), weighing(2 * kMessage));
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, AMessageThatNeedsMoreThanTheLimitIsRefusedAtOnce) {
  StagedServer server{TransportLimits{.traffic_bytes = kMessage, .room = 600s}};
  Wire http{server.port()};
  http.send(post_request(weighing(2 * kMessage)));
  const HttpAnswer refused = http.answer().value_or(HttpAnswer{});
  EXPECT_EQ(refused.status, 503);
  EXPECT_EQ(refused.body, "no room");
  Wire lines{server.port()};
  lines.send(weighing(2 * kMessage) + "\n{\"n\":2}\n");
  EXPECT_EQ(lines.line(), "no room");
  EXPECT_EQ(lines.line(), "{\"n\":2}");
  WebSocketWire socket{server.port()};
  socket.send_text(weighing(2 * kMessage));
  EXPECT_EQ(socket.text(), "no room");
}

TEST(Traffic, AClientThatDoesNotReadItsNotificationsIsDisconnectedWhenThereIsNoRoom) {
  StagedServer server{TransportLimits{.backlog_bytes = std::size_t{1} << 30, .traffic_bytes = 10 * kMessage}};
  Wire wire{server.port()};
  wire.send("{\"hold\":1}\n");
  const HeldCall held = server.next_held();
  for (int k = 0; k < 1000 && !held.caller.stop_requested(); ++k) held.session->notify(std::string(kMessage, 'x'));
  EXPECT_TRUE(stops(held.caller));
  held.reply("done");
  EXPECT_TRUE(holds_at_most(server, 0));
}

TEST(Traffic, ClientsThatNeedLittleAreServedWhateverTheOthersDo) {
  constexpr std::size_t kMiB = std::size_t{1} << 20;
  StagedServer server{TransportLimits{.traffic_bytes = 8 * kMiB, .room = 600s}};
  std::vector<std::unique_ptr<Wire>> greedy;
  std::vector<HeldCall> held;
  for (int k = 0; k < 6; ++k) {
    greedy.push_back(std::make_unique<Wire>(server.port()));
    greedy.back()->send(weighing(kMiB, "\"hold\":1") + "\n");
    held.push_back(server.next_held());
  }
  Wire more{server.port()};
  more.send(weighing(kMiB, "\"hold\":2") + "\n");
  for (int k = 0; k < 50; ++k) {
    const HttpAnswer answer = Wire{server.port()}.post(weighing(kMessage)).value_or(HttpAnswer{});
    ASSERT_EQ(answer.status, 200) << k;
  }
  EXPECT_EQ(server.held(), 0U);  // it would take what is left for small ones
  for (const HeldCall& call : held) call.reply("done");
  server.next_held().reply("done, too");
  EXPECT_EQ(more.line(), "done, too");
}

}  // namespace
}  // namespace selvage::test
