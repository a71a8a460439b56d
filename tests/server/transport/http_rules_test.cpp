#include "server/transport/access/http_rules.h"

#include <gtest/gtest.h>

namespace selvage::server::transport {
namespace {

TEST(HttpRules, LocalHosts) {
  for (const auto* host :
       {"localhost", "LocalHost", "localhost:7171", "127.0.0.1", "127.0.0.1:1", "[::1]", "[::1]:65535"}) {
    EXPECT_TRUE(access::is_local_host(host)) << host;
  }
}

TEST(HttpRules, ForeignHosts) {
  for (const auto* host : {"", "example.com", "localhost.example.com", "127.0.0.1.example.com",
                           "localhost:", "localhost:x", "localhost:123456", "localhost:80@example.com",
                           "user@localhost", "::1", "127.0.0.2", " localhost", "localhost "}) {
    EXPECT_FALSE(access::is_local_host(host)) << host;
  }
}

TEST(HttpRules, Origins) {
  EXPECT_TRUE(access::is_local_origin("http://localhost:3000"));
  EXPECT_TRUE(access::is_local_origin("https://127.0.0.1"));
  for (const auto* origin : {"", "null", "localhost", "http://example.com", "file://localhost", "http://localhost/",
                             "http://localhost.example.com"}) {
    EXPECT_FALSE(access::is_local_origin(origin)) << origin;
  }
}

}  // namespace
}  // namespace selvage::server::transport
