// The client over TLS, with daemons that have a self-signed certificate.
#include <gtest/gtest.h>

#include "tests/clients/cpp/live_daemon.h"
#include "tests/server/store/temporary_folder.h"
#include "tests/server/wire/certificate.h"

namespace selvage::test {
namespace {

class Encrypted : public ::testing::Test {
 protected:
  // The certificate is for "localhost".
  [[nodiscard]] std::string address(const std::string& host = "localhost") const {
    return "tls://" + host + daemon_.tcp().substr(daemon_.tcp().find(':'));
  }
  // With a long time limit, so that the test hangs if the client tries again.
  static Settings trusting(const std::string& certificate) {
    return {.trusted = certificate, .connect_for = std::chrono::hours{1}};
  }

  TemporaryFolder folder_;
  server::transport::access::TlsFiles files_{write_certificate(folder_.path())};
  LiveDaemon daemon_{{"--tls-cert", files_.certificate, "--tls-key", files_.key}};
};

TEST_F(Encrypted, CallsAndLongAnswersArrive) {
  Client client{address(), trusting(files_.certificate)};
  const Answer opened = client.call("marker.open", {{"marker", garment("jeans_22g")}});
  ASSERT_TRUE(opened) << opened.error().message;
  const Answer got = client.call("marker.get", {{"markerId", (*opened)["markerId"]}, {"format", "outlines"}});
  ASSERT_TRUE(got) << got.error().message;
  EXPECT_GT(got->dump().size(), 100'000U);
}

TEST_F(Encrypted, AnUntrustedCertificateIsNotRetried) {
  Client client{address(), trusting("")};
  const Answer answer = client.call("engine.info");
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kUntrusted);
  EXPECT_NE(answer.error().message.find("certificate verify failed"), std::string::npos) << answer.error().message;
}

TEST_F(Encrypted, ACertificateForAnotherHostIsNotTrusted) {
  Client client{address("127.0.0.1"), trusting(files_.certificate)};
  const Answer answer = client.call("engine.info");
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kUntrusted);
}

TEST(Plain, ADaemonWithoutTlsIsUntrusted) {
  const LiveDaemon daemon;
  Client client{"tls://" + daemon.tcp(), {.connect_for = std::chrono::hours{1}}};
  const Answer answer = client.call("engine.info");
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.error().code, CallCode::kUntrusted);
}

}  // namespace
}  // namespace selvage::test
