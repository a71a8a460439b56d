// Connections that break at the worst moment.  The server is a part of the test and sends only the answers that the
// test chooses.
#include <gtest/gtest.h>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/write.hpp>

#include <atomic>
#include <chrono>
#include <future>
#include <optional>

#include "tests/clients/cpp/live_daemon.h"

namespace selvage::test {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;

class StagedServer {
 public:
  [[nodiscard]] std::string address() const { return "127.0.0.1:" + std::to_string(acceptor_.local_endpoint().port()); }
  void accept() {
    received_.clear();
    socket_.emplace(acceptor_.accept());
  }
  Json receive() {
    const std::size_t size = asio::read_until(*socket_, asio::dynamic_buffer(received_), '\n');
    Json message = Json::parse(received_.substr(0, size));
    received_.erase(0, size);
    return message;
  }
  void answer(const Json& id, const Json& result) { send({{"jsonrpc", "2.0"}, {"id", id}, {"result", result}}); }
  void refuse(const Json& id) {
    const Json error{{"code", CallCode::kBusy}, {"message", "the server is loading its markers"}};
    send({{"jsonrpc", "2.0"}, {"id", id}, {"error", error}});
  }
  void disconnect() { socket_.reset(); }
  void stop_listening() { acceptor_.close(); }

 private:
  void send(const Json& message) { asio::write(*socket_, asio::buffer(message.dump() + "\n")); }

  asio::io_context io_;
  tcp::acceptor acceptor_{io_, {asio::ip::address_v4::loopback(), 0}};
  std::optional<tcp::socket> socket_;
  std::string received_;
};

TEST(BrokenConnection, AChangeIsSentAgainWithTheSameOpId) {
  StagedServer server;
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
  StagedServer server;
  Client client{server.address()};
  Call call = client.begin("marker.undo", {{"markerId", "m1"}, {"opId", "mine"}});
  server.accept();
  EXPECT_EQ(server.receive()["params"]["opId"], "mine");
  Call reading = client.begin("marker.get", {{"markerId", "m1"}});
  EXPECT_FALSE(server.receive()["params"].contains("opId"));
}

TEST(BrokenConnection, ACallThatMustNotBeRepeatedIsNotSentAgain) {
  StagedServer server;
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
void watch_and_reconnect(StagedServer& server, Client& client) {
  Call watch = client.begin("marker.watch", {{"markerId", "m7"}});
  server.accept();
  server.answer(server.receive()["id"], {{"watching", true}});
  ASSERT_TRUE(watch.answer.get());
  server.disconnect();
  server.accept();
}

TEST(BrokenConnection, WatchesAreRestored) {
  StagedServer server;
  Client client{server.address()};
  ASSERT_NO_FATAL_FAILURE(watch_and_reconnect(server, client));
  const Json again = server.receive();
  EXPECT_EQ(again["method"], "marker.watch");
  EXPECT_EQ(again["params"]["markerId"], "m7");
}

// Once the connection is reported as restored, the caller reads the marker again.  A change between that and the watch
// would be missed.
TEST(BrokenConnection, IsReportedAsRestoredOnceALoadingDaemonAcceptsTheWatches) {
  StagedServer server;
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
  StagedServer server;
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

TEST(BrokenConnection, ABusyDaemonsRefusalIsReturnedOnAFirstConnection) {
  StagedServer server;
  Client client{server.address()};
  Call call = client.begin("engine.info");
  server.accept();
  server.refuse(server.receive()["id"]);
  const Answer answer = call.answer.get();
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kBusy);
}

TEST(BrokenConnection, GivesUpAfterTheTimeLimit) {
  StagedServer server;
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
  StagedServer server;
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
