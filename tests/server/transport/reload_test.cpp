// The token and the certificate, replaced while the server runs.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/server/store/temporary_folder.h"
#include "tests/server/transport/staged_server.h"
#include "tests/server/wire/certificate.h"

namespace selvage::test {
namespace {

using server::transport::access::Listener;
using server::transport::access::ListenSettings;

constexpr const char* kOld = "correct horse battery";
constexpr const char* kNew = "different horse staple";

int status(StagedServer& server, const std::string& token) {
  Wire wire{server.port()};
  wire.send(post_request("{}", "Authorization: Bearer " + token + "\r\n"));
  return wire.answer().value_or(HttpAnswer{}).status;
}

TEST(Reload, ANewTokenReplacesTheOld) {
  ListenSettings listen;
  listen.listeners = {{.speaks = Listener::Speaks::kHttp, .host = "127.0.0.1"},
                      {.speaks = Listener::Speaks::kLines, .host = "127.0.0.1"}};
  listen.access.token = kOld;
  StagedServer server{listen};
  Wire kept{server.port()};
  kept.send(post_request("{}", "Authorization: Bearer " + std::string{kOld} + "\r\n"));
  EXPECT_EQ(kept.answer().value_or(HttpAnswer{}).status, 200);
  Wire lines{server.transport().listeners().at(1).port};
  lines.send(std::string{kOld} + "\n");
  EXPECT_EQ(lines.line(), "come in");

  server.transport().reload(kNew, std::nullopt);
  EXPECT_EQ(status(server, kNew), 200);
  EXPECT_EQ(status(server, kOld), 401);
  kept.send(post_request("{}", "Authorization: Bearer " + std::string{kOld} + "\r\n"));  // each request has its token
  EXPECT_EQ(kept.answer().value_or(HttpAnswer{}).status, 401);
  lines.send("{\"n\":1}\n");
  EXPECT_EQ(lines.line(), "{\"n\":1}");  // it has authenticated
}

TEST(Reload, ANewCertificateIsUsedForNewConnections) {
  const TemporaryFolder old_files;
  const TemporaryFolder new_files;
  ListenSettings listen;
  listen.tls = write_certificate(old_files.path());
  StagedServer server{listen};
  const auto certificate = [&] {
    Wire wire{server.port()};
    EXPECT_TRUE(wire.begin_tls());
    return wire.certificate();
  };
  Wire kept{server.port()};
  ASSERT_TRUE(kept.begin_tls());
  EXPECT_EQ(certificate(), kept.certificate());

  server.transport().reload("", write_certificate(new_files.path()));
  EXPECT_NE(certificate(), kept.certificate());
  EXPECT_EQ(kept.post("{}").value_or(HttpAnswer{}).status, 200);
}

TEST(Reload, UnusableFilesReplaceNothing) {
  const TemporaryFolder folder;
  const TemporaryFolder other_folder;
  ListenSettings listen;
  listen.tls = write_certificate(folder.path());
  const server::transport::access::TlsFiles other = write_certificate(other_folder.path());
  StagedServer server{listen};
  EXPECT_THROW(server.transport().reload("", {{folder.file("none"), listen.tls->key}}), std::exception);
  // Half of a replacement: the key does not belong to the certificate.
  EXPECT_THROW(server.transport().reload("", {{other.certificate, listen.tls->key}}), std::exception);
  Wire wire{server.port()};
  ASSERT_TRUE(wire.begin_tls());
  EXPECT_EQ(wire.post("{}").value_or(HttpAnswer{}).status, 200);
}

}  // namespace
}  // namespace selvage::test
