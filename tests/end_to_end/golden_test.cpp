// The golden exchanges of tests/golden/rpc, each file sent to a new daemon over HTTP, lines and a WebSocket.
#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>

#include "server/app/daemon.h"
#include "tests/end_to_end/calls.h"
#include "tests/server/wire/websocket_wire.h"
#include "tests/support/repository.h"

namespace selvage::test {
namespace {

// Equal except for "$any", with exactly the same fields.
bool alike(const Json& expected, const Json& actual) {
  if (expected == "$any") return true;
  if (!expected.is_object() || !actual.is_object()) return expected == actual;
  if (expected.size() != actual.size()) return false;
  for (const auto& [key, value] : expected.items()) {
    if (!actual.contains(key) || !alike(value, actual[key])) return false;
  }
  return true;
}

// A connection to a daemon that sends one message at a time.
class ClientTransport {
 public:
  ClientTransport() = default;
  virtual ~ClientTransport() = default;
  ClientTransport(const ClientTransport&) = delete;
  ClientTransport& operator=(const ClientTransport&) = delete;
  virtual void send(const std::string& request) = 0;
  // The next message; empty if the connection has ended.
  virtual std::string receive() = 0;
};

class Http final : public ClientTransport {
 public:
  explicit Http(std::uint16_t port) : wire_{port} {}
  void send(const std::string& request) override { wire_.send(post_request(request)); }
  std::string receive() override { return wire_.answer().value_or(HttpAnswer{}).body; }

 private:
  Wire wire_;
};

class Lines final : public ClientTransport {
 public:
  explicit Lines(std::uint16_t port) : wire_{port} {}
  void send(const std::string& request) override { wire_.send(request + "\n"); }
  std::string receive() override { return wire_.line().value_or(""); }

 private:
  Wire wire_;
};

class WebSocket final : public ClientTransport {
 public:
  explicit WebSocket(std::uint16_t port) : wire_{port} {}
  void send(const std::string& request) override { wire_.send_text(request); }
  std::string receive() override { return wire_.text().value_or(""); }

 private:
  WebSocketWire wire_;
};

std::unique_ptr<ClientTransport> connect_by(const server::app::Daemon& daemon, const std::string& name) {
  if (name == "http") return std::make_unique<Http>(daemon.port());
  if (name == "lines") return std::make_unique<Lines>(daemon.port());
  return std::make_unique<WebSocket>(daemon.port());
}

class GoldenExchanges : public ::testing::TestWithParam<std::tuple<const char*, const char*>> {};

// The next message that is an answer; notifications before it are added to a list.
Json answer_over(ClientTransport& transport, Json& notifications) {
  for (;;) {
    const std::string text = transport.receive();
    if (text.empty()) return {};
    Json message = Json::parse(text);
    if (!message.contains("method")) return message;
    notifications.push_back(std::move(message));
  }
}

TEST_P(GoldenExchanges, MatchTheDaemonsAnswers) {
  const auto& [name, transport_name] = GetParam();
  const Json exchanges = Json::parse(repository_text(std::string{"tests/golden/rpc/"} + name + ".json"));
  ASSERT_FALSE(exchanges.empty());
  const server::app::Daemon daemon{on_free_port(1)};
  std::map<std::string, std::unique_ptr<ClientTransport>> connections;  // by sender
  Json expected_notifications = Json::array();
  std::map<std::string, Json> notifications;
  for (const Json& exchange : exchanges) {
    for (const Json& each : exchange.value("notifications", Json::array())) expected_notifications.push_back(each);
    const std::string request = protocol::json::to_text(exchange["request"]);
    const std::string sender = exchange.value("sender", std::string{});
    auto& connection = connections[sender];
    if (!connection) connection = connect_by(daemon, transport_name);
    connection->send(request);
    const Json answer = answer_over(*connection, notifications.try_emplace(sender, Json::array()).first->second);
    ASSERT_TRUE(answer.is_object()) << request;
    EXPECT_TRUE(alike(exchange["response"], answer))
        << request << "\nexpected " << protocol::json::to_text(exchange["response"]) << "\nanswered "
        << protocol::json::to_text(answer);
  }
  for (const auto& [sender, received] : notifications) {
    const Json expected = sender.empty() ? expected_notifications : Json::array();
    ASSERT_EQ(received.size(), expected.size()) << sender << protocol::json::to_text(received);
    for (std::size_t i = 0; i < received.size(); ++i)
      EXPECT_TRUE(alike(expected[i], received[i])) << protocol::json::to_text(received[i]);
  }
}

TEST(Readme, ExplainsEveryMethodOfTheDaemon) {
  const std::string text = repository_text("protocol/README.md");
  server::app::Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  const Json info = result_of(post_call(wire, "engine.info"));
  ASSERT_GT(info["methods"].size(), 20U);
  for (const Json& name : info["methods"]) {
    EXPECT_NE(text.find("| `" + name.get<std::string>() + "` |"), std::string::npos) << name;
  }
}

std::string name_of(const ::testing::TestParamInfo<GoldenExchanges::ParamType>& tested) {
  return std::string{std::get<0>(tested.param)} + "_" + std::get<1>(tested.param);
}

INSTANTIATE_TEST_SUITE_P(All, GoldenExchanges,
                         ::testing::Combine(::testing::Values("life_of_a_marker", "mistakes", "motions", "changes",
                                                              "dragging", "places_and_tilts", "nesting", "planning",
                                                              "remaking", "allowances", "cloth_rules", "cloth_repeat",
                                                              "cloth_zones"),
                                            ::testing::Values("http", "lines", "websocket")),
                         name_of);
// Over HTTP there are no notifications.
INSTANTIATE_TEST_SUITE_P(Notifications, GoldenExchanges,
                         ::testing::Combine(::testing::Values("watching", "dragged"),
                                            ::testing::Values("lines", "websocket")),
                         name_of);

}  // namespace
}  // namespace selvage::test
