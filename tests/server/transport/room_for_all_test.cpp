// No client can lock others out by opening connections: which connection is closed to make room, and the listener for
// health checks.
#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>

#include <memory>
#include <string>
#include <vector>

#include "server/transport/connection_table.h"
#include "tests/server/store/temporary_folder.h"
#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/certificate.h"

namespace selvage::test {
namespace {

using server::transport::ConnectionTable;
using server::transport::access::Listener;
using server::transport::access::ListenSettings;
using server::transport::access::Refusal;
using server::transport::access::TransportLimits;
using server::transport::connections::Connection;
using Standing = Connection::Standing;

std::uint64_t refused(const StagedServer& server, Refusal refusal) {
  return server.counts().refused.at(static_cast<std::size_t>(refusal));
}

class Table : public ::testing::Test {
 protected:
  ConnectionTable::Entry open(const std::string& address, Standing standing) {
    auto connection =
        std::make_shared<Connection>(server::transport::connections::Socket{io_}, ++last_id_, address, false);
    connection->set_standing(standing);
    table_.insert(connection, address);
    return connection;
  }
  // The session that is closed to make room for a connection from this address; 0 if none is.
  std::uint64_t closed_for(const std::string& address) {
    std::uint64_t closed = 0;
    refusal_ = table_.make_room(address, [&](const ConnectionTable::Entry& one) { closed = one->session->id; });
    return closed;
  }

  boost::asio::io_context io_;
  const TransportLimits limits_{.connections = 4, .connections_per_address = 3};
  ConnectionTable table_{limits_};
  std::optional<Refusal> refusal_;
  std::uint64_t last_id_{};
};

TEST_F(Table, ClosesNothingWhileThereIsRoom) {
  for (const auto* address : {"a", "a", "b"}) open(address, Standing::kSilent);
  EXPECT_EQ(closed_for("a"), 0U);
  EXPECT_EQ(refusal_, std::nullopt);
  EXPECT_EQ(table_.size(), 3U);
}

TEST_F(Table, ClosesTheOldestOfTheAddressWithTheMostConnections) {
  open("a", Standing::kSilent);
  open("b", Standing::kServed);
  open("b", Standing::kSilent);
  open("b", Standing::kSilent);
  EXPECT_EQ(closed_for("c"), 3U);
  EXPECT_EQ(refusal_, std::nullopt);
  EXPECT_EQ(table_.size(), 3U);
}

TEST_F(Table, ClosesSilentConnectionsBeforeIdleOnesAndNeverAServedOne) {
  open("a", Standing::kIdle);
  open("b", Standing::kServed);
  open("c", Standing::kSilent);
  open("d", Standing::kServed);
  EXPECT_EQ(closed_for("e"), 3U);
  open("e", Standing::kServed);
  EXPECT_EQ(closed_for("f"), 1U);
  open("f", Standing::kServed);
  EXPECT_EQ(closed_for("g"), 0U);
  EXPECT_EQ(refusal_, Refusal::kConnections);
}

TEST_F(Table, AnAddressMakesRoomAmongItsOwn) {
  for (int k = 0; k < 3; ++k) open("a", Standing::kServed);
  EXPECT_EQ(closed_for("a"), 0U);
  EXPECT_EQ(refusal_, Refusal::kAddress);
  EXPECT_EQ(closed_for("b"), 0U);
  EXPECT_EQ(refusal_, std::nullopt);
}

TEST_F(Table, UnixSocketsAreNotLimitedByAddress) {
  for (int k = 0; k < 3; ++k) open("", Standing::kServed);
  EXPECT_EQ(closed_for(""), 0U);
  EXPECT_EQ(refusal_, std::nullopt);
}

TEST(RoomForAll, SilentConnectionsMakeRoomForOthers) {
  StagedServer server{TransportLimits{.connections = 8}};
  std::vector<std::unique_ptr<Wire>> silent;
  for (int k = 0; k < 100; ++k) {
    silent.push_back(std::make_unique<Wire>(server.port()));
    if (k % 2 == 1) silent.back()->send("POST /rpc HTTP/1.1\r\nHost: loc");  // a request that never ends
  }
  Wire wire{server.port()};
  EXPECT_EQ(wire.post("{}").value_or(HttpAnswer{}).status, 200);
  EXPECT_EQ(refused(server, Refusal::kSilent), 93U);
  EXPECT_EQ(silent.front()->rest(), "");
}

TEST(RoomForAll, SilentConnectionsMakeRoomBeforeTheirTlsHandshakeToo) {
  const TemporaryFolder folder;
  ListenSettings listen;
  listen.tls = write_certificate(folder.path());
  StagedServer server{listen, TransportLimits{.connections = 2}};
  Wire first{server.port()};
  Wire second{server.port()};
  Wire third{server.port()};
  ASSERT_TRUE(third.begin_tls());
  EXPECT_EQ(third.post("{}").value_or(HttpAnswer{}).status, 200);
  EXPECT_EQ(first.rest(), "");
}

TEST(RoomForAll, AnAddressHasALimitOfItsOwn) {
  StagedServer server{TransportLimits{.connections = 10, .connections_per_address = 2}};
  Wire first{server.port()};
  Wire second{server.port()};
  for (Wire* wire : {&first, &second}) wire->send(post_request("hold"));
  const HeldCall held = server.next_held();
  const HeldCall other = server.next_held();
  EXPECT_EQ(Wire{server.port()}.rest(), "");
  EXPECT_EQ(refused(server, Refusal::kAddress), 1U);
  held.reply("1");
  other.reply("2");
  EXPECT_TRUE(first.answer() && second.answer());
}

TEST(RoomForAll, HealthIsAnsweredWhenAllConnectionsAreTaken) {
  ListenSettings listen;
  listen.listeners = {{.speaks = Listener::Speaks::kHttp, .host = "127.0.0.1"},
                      {.speaks = Listener::Speaks::kHealth, .host = "127.0.0.1"}};
  listen.access.token = "correct horse battery";
  StagedServer server{listen, TransportLimits{.connections = 1}};
  Wire busy{server.port()};
  busy.send(post_request("hold", "Authorization: Bearer correct horse battery\r\n"));
  const HeldCall held = server.next_held();
  EXPECT_EQ(Wire{server.port()}.rest(), "");

  const std::uint16_t port = server.transport().listeners().at(1).port;
  std::vector<std::unique_ptr<Wire>> silent;
  for (int k = 0; k < 100; ++k) silent.push_back(std::make_unique<Wire>(port));
  Wire probe{port};
  const auto status = [&](const std::string& request) {
    probe.send(request);
    return probe.answer().value_or(HttpAnswer{}).status;
  };
  EXPECT_EQ(status("GET /healthz HTTP/1.1\r\nHost: 10.1.2.3:9000\r\n\r\n"), 200);
  EXPECT_EQ(status("GET /readyz HTTP/1.1\r\nHost: pod.cluster.local\r\n\r\n"), 200);
  server.set_why_not_ready("full");
  EXPECT_EQ(status("GET /readyz HTTP/1.1\r\nHost: pod.cluster.local\r\n\r\n"), 503);
  EXPECT_EQ(silent.front()->rest(), "");
  held.reply("done");
}

TEST(RoomForAll, TheListenerForHealthChecksServesNothingElse) {
  ListenSettings listen;
  listen.listeners = {{.speaks = Listener::Speaks::kHttp, .host = "127.0.0.1"},
                      {.speaks = Listener::Speaks::kHealth, .host = "127.0.0.1"}};
  StagedServer server{listen};
  const std::uint16_t port = server.transport().listeners().at(1).port;
  for (const std::string& request :
       {post_request("{}"), std::string{"GET /metrics HTTP/1.1\r\nHost: localhost\r\n\r\n"},
        std::string{"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n"},
        std::string{"GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\r\n"}}) {
    Wire wire{port};
    wire.send(request);
    EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).status, 404) << request;
  }
  Wire lines{port};
  lines.send("{\"hold\":1}\n\r\n\r\n");
  EXPECT_EQ(lines.answer().value_or(HttpAnswer{}).status, 400);
  EXPECT_EQ(server.held(), 0U);
}

}  // namespace
}  // namespace selvage::test
