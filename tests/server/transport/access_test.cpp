#include "server/transport/access/access.h"

#include <gtest/gtest.h>

namespace selvage::server::transport {
namespace {

TEST(Access, WithoutATokenAnyValueMatches) {
  const access::Access access;
  EXPECT_TRUE(token_matches(access, ""));
  EXPECT_TRUE(authorization_matches(access, ""));
  EXPECT_TRUE(authorization_matches(access, "Basic abc"));
}

TEST(Access, ATokenMustMatchCompletely) {
  const access::Access access{.token = "correct horse"};
  EXPECT_TRUE(token_matches(access, "correct horse"));
  for (const auto* token : {"", "correct", "correct horse ", "correct hors\xff", "Correct horse"}) {
    EXPECT_FALSE(token_matches(access, token)) << token;
  }
  EXPECT_TRUE(authorization_matches(access, "Bearer correct horse"));
  EXPECT_TRUE(authorization_matches(access, "bEARER  correct horse"));
  for (const auto* value : {"", "Bearer", "Bearer ", "Bearercorrect horse", "correct horse", "Basic correct horse"}) {
    EXPECT_FALSE(authorization_matches(access, value)) << value;
  }
}

TEST(Access, HostsAreCheckedOnlyWithoutAToken) {
  EXPECT_TRUE(access::host_allowed({.token = "correct horse"}, "anywhere.example"));
  const access::Access named{.hosts = {"marker.example"}};
  EXPECT_TRUE(host_allowed(named, "localhost:7171"));
  EXPECT_TRUE(host_allowed(named, "marker.example:80"));
  EXPECT_FALSE(host_allowed(named, "anywhere.example"));
}

TEST(Access, OriginsAreCheckedWithATokenToo) {
  const access::Access access{.token = "correct horse", .origins = {"https://front.example"}};
  EXPECT_TRUE(origin_allowed(access, "https://front.example"));
  EXPECT_TRUE(origin_allowed(access, "http://127.0.0.1:8080"));
  EXPECT_FALSE(origin_allowed(access, "https://anywhere.example"));
}

TEST(Access, PagesThatTheServerItselfHasServedMayCall) {
  const access::Access access{.hosts = {"marker.example"}};
  EXPECT_TRUE(origin_allowed(access, "https://marker.example", "marker.example"));
  EXPECT_TRUE(origin_allowed(access, "http://Marker.example:8080", "marker.example:8080"));
  EXPECT_FALSE(origin_allowed(access, "http://marker.example:8081", "marker.example:8080"));
  EXPECT_FALSE(origin_allowed(access, "http://marker.example.evil.example", "marker.example"));
  EXPECT_FALSE(origin_allowed(access, "https://evil.example", "marker.example"));
  EXPECT_FALSE(origin_allowed(access, "null", "null"));
  EXPECT_FALSE(origin_allowed(access, "https://", ""));
}

}  // namespace
}  // namespace selvage::server::transport
