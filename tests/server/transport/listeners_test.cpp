// Listeners: several at the same time, Unix sockets, tokens and TLS.
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <thread>

#include "tests/server/store/temporary_folder.h"
#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/certificate.h"
#include "tests/server/wire/websocket_wire.h"

namespace selvage::test {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kToken = "correct horse battery";

server::transport::access::Listener tcp(server::transport::access::Listener::Speaks speaks) {
  return {.speaks = speaks, .host = "127.0.0.1"};
}
server::transport::access::Listener unix_socket(const std::string& path) {
  return {.speaks = server::transport::access::Listener::Speaks::kLines, .path = path};
}

server::transport::access::ListenSettings with_token() {
  server::transport::access::ListenSettings listen;
  listen.listeners = {tcp(server::transport::access::Listener::Speaks::kHttp),
                      tcp(server::transport::access::Listener::Speaks::kLines)};
  listen.access.token = kToken;
  return listen;
}
std::uint16_t port_of_lines(StagedServer& server) {
  return server.transport().listeners().at(1).port;
}

// Leaves a socket in the file system on which nobody listens.
void leave_stale_socket(const std::string& path) {
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(&address.sun_path[0], sizeof address.sun_path - 1);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

TEST(Listeners, SeveralAreOpenAtTheSameTime) {
  const TemporaryFolder folder;
  server::transport::access::ListenSettings listen;
  listen.listeners = {tcp(server::transport::access::Listener::Speaks::kHttp),
                      tcp(server::transport::access::Listener::Speaks::kLines), unix_socket(folder.file("s"))};
  StagedServer server{listen};
  EXPECT_TRUE(Wire{server.port()}.post("{}"));
  Wire lines{port_of_lines(server)};
  lines.send("{\"n\":0}\n");
  EXPECT_EQ(lines.line(), "{\"n\":0}");
  Wire local{folder.file("s")};
  local.send("{\"n\":1}\n");
  EXPECT_EQ(local.line(), "{\"n\":1}");
  EXPECT_EQ(server.counts().lines, 2U);
}

TEST(UnixSocket, IsOpenToItsOwnerOnlyAndRemovedAtTheEnd) {
  const TemporaryFolder folder;
  const std::string path = folder.file("s");
  server::transport::access::ListenSettings listen;
  listen.listeners = {tcp(server::transport::access::Listener::Speaks::kHttp), unix_socket(path)};
  {
    StagedServer server{listen};
    struct stat found {};
    ASSERT_EQ(::lstat(path.c_str(), &found), 0);
    EXPECT_TRUE(S_ISSOCK(found.st_mode));
    EXPECT_EQ(found.st_mode & 0777, 0600U);
    EXPECT_THROW(StagedServer{listen}, std::exception);  // in use
    EXPECT_EQ(::lstat(path.c_str(), &found), 0);         // and unchanged
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST(UnixSocket, ReplacesAStaleSocketButNoOtherFile) {
  const TemporaryFolder folder;
  const std::string path = folder.file("s");
  leave_stale_socket(path);
  server::transport::access::ListenSettings listen;
  listen.listeners = {tcp(server::transport::access::Listener::Speaks::kHttp), unix_socket(path)};
  {
    StagedServer server{listen};
    Wire wire{path};
    wire.send("{}\n");
    EXPECT_EQ(wire.line(), "{}");
  }
  (void)folder.write("s", "precious");
  EXPECT_THROW(StagedServer{listen}, std::exception);
  EXPECT_EQ(std::filesystem::file_size(path), 8U);
}

TEST(UnixSocket, ClosingStopsTheCallsInProgress) {
  const TemporaryFolder folder;
  server::transport::access::ListenSettings listen;
  listen.listeners = {tcp(server::transport::access::Listener::Speaks::kHttp), unix_socket(folder.file("s"))};
  StagedServer server{listen};
  Wire wire{folder.file("s")};
  wire.send("{\"hold\":1}\n");
  const HeldCall held = server.next_held();
  wire.close();
  EXPECT_TRUE(stops(held.caller));
  held.reply("nobody reads this");
}

TEST(Token, HttpRequiresItExceptForHealthProbes) {
  StagedServer server{with_token()};
  const auto status = [&](const std::string& request) {
    Wire wire{server.port()};
    wire.send(request);
    return wire.answer().value_or(HttpAnswer{}).status;
  };
  const std::string right = "Authorization: Bearer " + std::string{kToken} + "\r\n";
  EXPECT_EQ(status(post_request("{}", right)), 200);
  EXPECT_EQ(status(post_request("{}", "authorization: bearer   " + std::string{kToken} + "\r\n")), 200);
  EXPECT_EQ(status(post_request("{}")), 401);
  EXPECT_EQ(status(post_request("{}", "Authorization: Bearer correct horse batterz\r\n")), 401);
  EXPECT_EQ(status(post_request("{}", "Authorization: Bearer correct horse\r\n")), 401);
  EXPECT_EQ(status(post_request("{}", "Authorization: Bearer\r\n")), 401);
  EXPECT_EQ(status(post_request("{}", "Authorization: Basic " + std::string{kToken} + "\r\n")), 401);
  EXPECT_EQ(status(post_request("{}", right + right)), 401);
  EXPECT_EQ(status("GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n"), 200);
  EXPECT_EQ(status("GET /readyz HTTP/1.1\r\nHost: localhost\r\n\r\n"), 200);
  EXPECT_EQ(status("GET /metrics HTTP/1.1\r\nHost: localhost\r\n\r\n"), 401);
  EXPECT_EQ(status("GET /metrics HTTP/1.1\r\nHost: localhost\r\n" + right + "\r\n"), 200);
  EXPECT_EQ(status("GET /secret HTTP/1.1\r\nHost: localhost\r\n\r\n"), 401);
  // A page of a foreign site does not know the token, so the host is not checked; the origin is checked nevertheless.
  EXPECT_EQ(status("GET /metrics HTTP/1.1\r\nHost: marker.example\r\n" + right + "\r\n"), 200);
  EXPECT_EQ(status(post_request("{}", right + "Origin: http://example.com\r\n")), 403);
}

TEST(Token, ARefusalSaysWhatToSend) {
  StagedServer server{with_token()};
  const auto answer = Wire{server.port()}.post("{}");
  ASSERT_TRUE(answer);
  EXPECT_TRUE(answer->says("WWW-Authenticate: Bearer\r\n"));
  EXPECT_TRUE(answer->says("Connection: close"));
}

TEST(Token, AWebSocketUpgradeWithAWrongTokenIsRefused) {
  StagedServer server{with_token()};
  EXPECT_EQ((WebSocketWire{server.port(), "Authorization: Bearer correct horse batterz\r\n"}.status()), 401);
  WebSocketWire socket{server.port(), "Authorization: Bearer " + std::string{kToken} + "\r\n"};
  EXPECT_EQ(socket.status(), 101);
  socket.send_text("{}");
  EXPECT_EQ(socket.text(), "{}");
}

// A web page cannot add a header to an upgrade request.
TEST(Token, AWebSocketMaySendItInItsFirstMessage) {
  StagedServer server{with_token()};
  WebSocketWire known{server.port()};
  EXPECT_EQ(known.status(), 101);
  known.send_text(std::string{kToken});
  EXPECT_EQ(known.text(), "come in");
  known.send_text("{\"n\":1}");
  EXPECT_EQ(known.text(), "{\"n\":1}");
  known.send_text(std::string(100'000, 'x'));
  EXPECT_EQ(known.text(), std::string(100'000, 'x'));
  WebSocketWire stranger{server.port()};
  stranger.send_text("{\"hold\":1}");
  stranger.send_text("{\"hold\":2}");
  EXPECT_EQ(stranger.text(), "stay out");
  EXPECT_EQ(stranger.frame().value_or(Frame{}).close_code(), 1008);
  WebSocketWire endless{server.port()};
  endless.send_text(std::string(100'000, 'x'));
  EXPECT_EQ(endless.frame().value_or(Frame{}).close_code(), 1009);
  EXPECT_EQ((WebSocketWire{server.port(), "Origin: http://example.com\r\n"}.status()), 403);
  EXPECT_EQ(server.held(), 0U);
}

TEST(Token, ALineConnectionMustBeginWithIt) {
  StagedServer server{with_token()};
  Wire known{port_of_lines(server)};
  known.send(std::string{kToken} + "\n{\"n\":1}\n");
  EXPECT_EQ(known.line(), "come in");
  EXPECT_EQ(known.line(), "{\"n\":1}");
  Wire stranger{port_of_lines(server)};
  stranger.send("{\"hold\":1}\n{\"hold\":2}\n");
  EXPECT_EQ(stranger.rest(), "stay out\n");
  Wire sniffed{server.port()};
  sniffed.send("{\"hold\":1}\n");
  EXPECT_EQ(sniffed.rest(), "stay out\n");
  Wire endless{port_of_lines(server)};
  (void)endless.try_send(std::string(1 << 20, 'x'));
  EXPECT_EQ(endless.rest(), "");
  EXPECT_EQ(server.held(), 0U);
}

TEST(Token, TheTimeToSendItIsLimited) {
  server::transport::access::TransportLimits limits;
  limits.request = 50ms;
  StagedServer server{with_token(), limits};
  Wire wire{port_of_lines(server)};
  wire.send("correct hor");
  EXPECT_EQ(wire.rest(), "");
}

TEST(Token, AUnixSocketRequiresNone) {
  const TemporaryFolder folder;
  server::transport::access::ListenSettings listen = with_token();
  listen.listeners.push_back(unix_socket(folder.file("s")));
  StagedServer server{listen};
  Wire wire{folder.file("s")};
  wire.send("{\"n\":1}\n");
  EXPECT_EQ(wire.line(), "{\"n\":1}");
}

TEST(Access, ConfiguredHostsAndOriginsMayCall) {
  server::transport::access::ListenSettings listen;
  listen.access.hosts = {"marker.example"};
  listen.access.origins = {"https://front.example"};
  StagedServer server{listen};
  const auto status = [&](const std::string& host, const std::string& origin) {
    Wire wire{server.port()};
    wire.send("GET /healthz HTTP/1.1\r\nHost: " + host + "\r\nOrigin: " + origin + "\r\n\r\n");
    return wire.answer().value_or(HttpAnswer{}).status;
  };
  EXPECT_EQ(status("marker.example", "https://front.example"), 200);
  EXPECT_EQ(status("Marker.Example:443", "http://localhost"), 200);
  EXPECT_EQ(status("marker.example.com", "https://front.example"), 403);
  EXPECT_EQ(status("marker.example", "https://front.example:8443"), 403);
  EXPECT_EQ(status("marker.example", "http://front.example"), 403);
}

class WithTls : public ::testing::Test {
 protected:
  [[nodiscard]] server::transport::access::ListenSettings listen() const {
    server::transport::access::ListenSettings listen;
    listen.listeners = {tcp(server::transport::access::Listener::Speaks::kHttp),
                        tcp(server::transport::access::Listener::Speaks::kLines)};
    listen.tls = write_certificate(folder_.path());
    return listen;
  }
  const TemporaryFolder folder_;
};

TEST_F(WithTls, HttpAndLinesAreEncrypted) {
  StagedServer server{listen()};
  Wire http{server.port()};
  ASSERT_TRUE(http.begin_tls());
  EXPECT_EQ(http.post("{\"n\":1}").value_or(HttpAnswer{}).body, "{\"n\":1}");
  EXPECT_EQ(http.post("{\"n\":2}").value_or(HttpAnswer{}).body, "{\"n\":2}");
  Wire lines{port_of_lines(server)};
  ASSERT_TRUE(lines.begin_tls());
  const std::string large = "{\"" + std::string(3'000'000, 'x') + "\":1}";
  lines.send(large + "\n");
  EXPECT_EQ(lines.line(), large);
}

TEST_F(WithTls, AHalfClosedConnectionStillGetsItsAnswers) {
  StagedServer server{listen()};
  Wire lines{port_of_lines(server)};
  ASSERT_TRUE(lines.begin_tls());
  lines.send("{\"hold\":1}\n");
  lines.half_close();
  const HeldCall held = server.next_held();
  held.reply("done");
  EXPECT_EQ(lines.rest(), "done\n");
}

TEST_F(WithTls, ABrokenConnectionStopsItsCalls) {
  StagedServer server{listen()};
  for (const std::uint16_t port : {server.port(), port_of_lines(server)}) {
    Wire wire{port};
    ASSERT_TRUE(wire.begin_tls());
    wire.send(port == server.port() ? post_request("hold") : "{\"hold\":1}\n");
    const HeldCall held = server.next_held();
    wire.reset();
    EXPECT_TRUE(stops(held.caller));
    held.reply("nobody reads this");
  }
}

TEST_F(WithTls, ClearTextGetsNoAnswer) {
  StagedServer server{listen()};
  Wire wire{server.port()};
  wire.send(post_request("hold"));
  EXPECT_EQ(wire.rest().find("HTTP/"), std::string::npos);
  EXPECT_EQ(server.held(), 0U);
  Wire other{server.port()};
  EXPECT_TRUE(other.begin_tls());
}

TEST_F(WithTls, DrainingSendsAllAnswers) {
  StagedServer server{listen()};
  Wire wire{server.port()};
  ASSERT_TRUE(wire.begin_tls());
  wire.send(post_request("hold"));
  const HeldCall held = server.next_held();
  server.transport().stop_reading();
  held.reply(std::string(1 << 20, 'x'));
  std::jthread finishing{[&server] { server.transport().finish(kPatience); }};
  EXPECT_EQ(wire.answer().value_or(HttpAnswer{}).body.size(), 1U << 20);
  EXPECT_EQ(wire.rest(), "");
}

TEST_F(WithTls, TheErrorNamesAFileThatCannotBeUsed) {
  server::transport::access::ListenSettings wrong = listen();
  wrong.tls->key = folder_.file("missing.pem");
  try {
    const StagedServer server{wrong};
    ADD_FAILURE() << "a missing key was accepted";
  } catch (const std::exception& error) {
    EXPECT_NE(std::string{error.what()}.find("missing.pem"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace selvage::test
