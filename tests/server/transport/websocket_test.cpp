// WebSocket over a real socket: messages in both directions, and how each kind of error ends.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/websocket_wire.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;

server::transport::access::TransportLimits small_messages() {
  server::transport::access::TransportLimits limits;
  limits.body_bytes = 1000;
  return limits;
}

// The status with which a request for /ws is refused; 0 if the connection ends without an answer.
int status_of(const StagedServer& server, const std::string& request) {
  Wire wire{server.port()};
  wire.send(request);
  return wire.answer().value_or(HttpAnswer{}).status;
}

// The close code of the connection; earlier frames are skipped.
int close_code(WebSocketWire& socket) {
  while (const auto frame = socket.frame()) {
    if (frame->opcode == Opcode::kClose) return frame->close_code();
  }
  return 0;
}

TEST(WebSocket, AnswersMessagesInOrderOfCompletion) {
  StagedServer server;
  WebSocketWire socket{server.port()};
  ASSERT_EQ(socket.status(), 101);
  EXPECT_EQ(server.counts().websockets, 1U);
  socket.send_text("{\"n\":1}");
  EXPECT_EQ(socket.text(), "{\"n\":1}");
  socket.send_text("hold 1");
  socket.send_text("silent");
  socket.send_text("quick");
  EXPECT_EQ(socket.text(), "quick");
  server.next_held().reply("one");
  EXPECT_EQ(socket.text(), "one");
}

TEST(WebSocket, AcceptsFragmentedMessagesOfAnySize) {
  StagedServer server;
  WebSocketWire socket{server.port()};
  socket.send({Opcode::kText, "{\"a\"", false});
  socket.send({Opcode::kPing, "in between"});
  socket.send({Opcode::kContinuation, ":1}", true});
  const auto pong = socket.frame();
  ASSERT_TRUE(pong);
  EXPECT_EQ(pong->opcode, Opcode::kPong);
  EXPECT_EQ(pong->payload, "in between");
  EXPECT_EQ(socket.text(), "{\"a\":1}");
  for (const std::size_t size : {1U, 125U, 126U, 65535U, 65536U, 3'000'000U}) {
    const std::string text(size, 'x');
    socket.send_text(text);
    EXPECT_EQ(socket.text(), text);
  }
}

TEST(WebSocket, SendsNotificationsInOrderFromAnyThread) {
  StagedServer server;
  WebSocketWire socket{server.port()};
  socket.send_text("hold");
  const HeldCall held = server.next_held();
  ASSERT_TRUE(held.session->notify);
  std::jthread other{[session = held.session] {
    for (int i = 0; i < 100; ++i) session->notify(std::to_string(i));
  }};
  for (int i = 0; i < 100; ++i) EXPECT_EQ(socket.text(), std::to_string(i));
  held.reply("done");
  EXPECT_EQ(socket.text(), "done");
  socket.wire().reset();
  EXPECT_TRUE(stops(held.session->gone));
  held.session->notify("nobody hears this");
}

TEST(WebSocket, HasOneSessionOfItsOwnForAllMessages) {
  StagedServer server;
  WebSocketWire first{server.port()};
  WebSocketWire second{server.port()};
  for (WebSocketWire* socket : {&first, &first, &second}) socket->send_text("hold");
  std::map<std::uint64_t, int> calls;
  for (int i = 0; i < 3; ++i) {
    const HeldCall held = server.next_held();
    ++calls[held.session->id];
    held.reply("done");
  }
  std::vector<int> counts;
  for (const auto& [id, count] : calls) counts.push_back(count);
  EXPECT_EQ(calls.size(), 2U);
  EXPECT_EQ(counts.at(0) * counts.at(1), 2);
}

TEST(WebSocket, RefusesForeignHostsAndOrigins) {
  StagedServer server;
  const auto request = [](const std::string& host) {
    std::string text = upgrade_request();
    return text.replace(text.find("localhost"), 9, host);
  };
  EXPECT_EQ(status_of(server, request("example.com")), 403);
  EXPECT_EQ(status_of(server, upgrade_request("Origin: http://example.com\r\n")), 403);
  EXPECT_EQ(status_of(server, upgrade_request("Origin: null\r\n")), 403);
  EXPECT_EQ(WebSocketWire(server.port(), "Origin: http://localhost:3000\r\n").status(), 101);
}

TEST(WebSocket, RefusesRequestsThatAreNotUpgrades) {
  StagedServer server;
  EXPECT_EQ(status_of(server, "GET /ws HTTP/1.1\r\nHost: localhost\r\n\r\n"), 426);
  EXPECT_EQ(status_of(server, "POST /ws HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n"), 405);
  EXPECT_EQ(status_of(server, upgrade_request("Content-Length: 2\r\n") + "{}"), 400);
  EXPECT_EQ(status_of(server, upgrade_request("Transfer-Encoding: chunked\r\n")), 411);
  EXPECT_EQ(status_of(server, upgrade_request() + frame_bytes({Opcode::kText, "too early"})), 400);
  std::string other_version = upgrade_request();
  other_version.replace(other_version.find("13\r\n"), 2, "12");
  EXPECT_EQ(status_of(server, other_version), 426);
}

TEST(WebSocket, OffersNoCompression) {
  StagedServer server;
  Wire wire{server.port()};
  wire.send(upgrade_request("Sec-WebSocket-Extensions: permessage-deflate\r\n"));
  const auto answer = wire.answer();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 101);
  EXPECT_FALSE(answer->says("permessage-deflate"));
}

TEST(WebSocket, ClosesWithTheCodeOfTheError) {
  StagedServer server{small_messages()};
  const auto code_after = [&](const std::string& bytes) {
    WebSocketWire socket{server.port()};
    socket.wire().send(bytes);
    return close_code(socket);
  };
  EXPECT_EQ(code_after(frame_bytes({Opcode::kBinary, "{}"})), 1003);
  EXPECT_EQ(code_after(frame_bytes({Opcode::kText, std::string(1001, 'x')})), 1009);
  EXPECT_EQ(code_after(frame_bytes({Opcode::kText, std::string(600, 'x'), false}) +
                       frame_bytes({Opcode::kContinuation, std::string(600, 'x')})),
            1009);
  EXPECT_EQ(code_after(frame_bytes({Opcode::kText, "\xff\xfe"})), 1007);
  EXPECT_EQ(code_after(frame_bytes({Opcode::kText, "{}"}, false)), 1002);   // unmasked
  EXPECT_EQ(code_after(frame_bytes({Opcode::kContinuation, "{}"})), 1002);  // continues no message
  EXPECT_EQ(code_after(frame_bytes({Opcode::kPing, std::string(126, 'x')})),
            1002);  // a control frame has at most 125 bytes
  EXPECT_EQ(code_after(frame_bytes({static_cast<Opcode>(3), "{}"})), 1002);
  EXPECT_EQ(code_after(frame_bytes({Opcode::kText, std::string(1000, 'x')}) +
                       frame_bytes({Opcode::kClose, std::string{"\x03\xe8", 2}})),
            1000);
  EXPECT_EQ(server.held(), 0U);
}

TEST(WebSocket, ClosingOrBreakingTheConnectionStopsItsCalls) {
  StagedServer server;
  for (const bool broken : {false, true}) {
    WebSocketWire socket{server.port()};
    socket.send_text("hold");
    const HeldCall held = server.next_held();
    EXPECT_FALSE(held.caller.stop_requested());
    if (broken) {
      socket.wire().reset();
    } else {
      socket.send({Opcode::kClose, std::string{"\x03\xe8", 2}});
    }
    EXPECT_TRUE(stops(held.caller));
    held.reply("nobody reads this");
  }
}

TEST(WebSocket, IsNotReadWhileTooManyCallsAreInProgress) {
  server::transport::access::TransportLimits limits;
  limits.calls_per_connection = 2;
  StagedServer server{limits};
  WebSocketWire socket{server.port()};
  for (int i = 0; i < 4; ++i) socket.send_text("hold " + std::to_string(i));
  std::vector<HeldCall> held;
  for (int i = 0; i < 2; ++i) held.push_back(server.next_held());
  ASSERT_TRUE(Wire{server.port()}.post("{}"));  // the I/O thread has handled everything,
  EXPECT_EQ(server.held(), 0U);                 // but not accepted the third call
  for (std::size_t i = 0; i < 4; ++i) {
    held[i].reply(std::to_string(i));
    EXPECT_EQ(socket.text(), std::to_string(i));
    if (i < 2) held.push_back(server.next_held());
  }
}

TEST(WebSocket, AnExceptionOfTheServiceEndsOnlyItsConnection) {
  StagedServer server;
  WebSocketWire socket{server.port()};
  WebSocketWire other{server.port()};
  socket.send_text("throw");
  EXPECT_FALSE(socket.text());
  other.send_text("still here");
  EXPECT_EQ(other.text(), "still here");
}

TEST(WebSocketTimes, ASilentClientThatDoesNotAnswerPingsIsDisconnected) {
  server::transport::access::TransportLimits limits;
  limits.ping = 50ms;
  limits.silence = 2s;
  StagedServer server{limits};
  WebSocketWire dead{server.port()};
  WebSocketWire alive{server.port()};
  std::jthread answering{[&alive] { EXPECT_FALSE(alive.text()); }};  // answers pings until the end
  int pings = 0;
  while (const auto frame = dead.frame()) pings += frame->opcode == Opcode::kPing ? 1 : 0;
  EXPECT_GT(pings, 0);
  // The client sees the end of the connection slightly before the server has cleaned up.
  const auto patience = std::chrono::steady_clock::now() + kPatience;
  while (server.counts().websockets != 1 && std::chrono::steady_clock::now() < patience) {
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_EQ(server.counts().websockets, 1U);
  server.transport().finish(kPatience);
}

TEST(WebSocketTimes, PongsDoNotExtendTheTimeOfAMessage) {
  server::transport::access::TransportLimits limits;
  limits.request = 50ms;
  StagedServer server{limits};
  WebSocketWire socket{server.port()};
  socket.send({Opcode::kText, "begun", false});
  EXPECT_FALSE(socket.text());
}

TEST(WebSocketTimes, AClientThatDoesNotReadIsDisconnected) {
  server::transport::access::TransportLimits limits;
  limits.write = 50ms;
  StagedServer server{limits};
  WebSocketWire socket{server.port()};
  socket.send_text("hold");
  const HeldCall held = server.next_held();
  held.reply(std::string(64 << 20, 'x'));
  EXPECT_TRUE(stops(held.caller));
}

TEST(WebSocketTimes, AClientThatDoesNotReadItsNotificationsIsDisconnected) {
  server::transport::access::TransportLimits limits;
  limits.backlog_bytes = 1 << 20;
  StagedServer server{limits};
  WebSocketWire socket{server.port()};
  socket.send_text("hold");
  const HeldCall held = server.next_held();
  const std::string text(1 << 20, 'x');
  for (int i = 0; i < 64; ++i) held.session->notify(text);
  EXPECT_TRUE(stops(held.caller));
  held.reply("nobody reads this");
}

TEST(WebSocketDrain, AnswersCallsInProgressAndThenCloses) {
  StagedServer server;
  WebSocketWire idle{server.port()};
  WebSocketWire busy{server.port()};
  busy.send_text("hold");
  const HeldCall held = server.next_held();
  server.transport().stop_reading();
  const auto farewell = idle.frame();
  ASSERT_TRUE(farewell);
  EXPECT_EQ(farewell->opcode, Opcode::kClose);
  EXPECT_EQ(farewell->close_code(), 1001);
  idle.send({Opcode::kClose, farewell->payload});
  EXPECT_FALSE(held.caller.stop_requested());
  held.reply("done");
  EXPECT_EQ(busy.text(), "done");
  const auto last = busy.frame();
  ASSERT_TRUE(last);
  EXPECT_EQ(last->close_code(), 1001);
  busy.send({Opcode::kClose, last->payload});
  server.transport().finish(kPatience);
  EXPECT_EQ(busy.wire().rest(), "");
}

}  // namespace
}  // namespace selvage::test
