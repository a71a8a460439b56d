// The page that is embedded in the program.
#include "server/room/room.h"

#include <gtest/gtest.h>

namespace selvage::server::room {
namespace {

TEST(Room, ServesThePageAndNothingElse) {
  const transport::access::StaticFile* page = find_file("/");
  ASSERT_NE(page, nullptr);
  EXPECT_EQ(page, find_file("/index.html"));
  EXPECT_EQ(page->type, "text/html; charset=utf-8");
  EXPECT_TRUE(page->gzip.starts_with("\x1f\x8b"));
  EXPECT_FALSE(page->forever);
  for (const char* other : {"", "index.html", "/room.js", "/../index.html", "//", "/index.html?x", "/rpc"}) {
    EXPECT_EQ(find_file(other), nullptr) << other;
  }
}

TEST(Room, AllowsThePageOnlyFilesOfTheServer) {
  const std::string_view policy = find_file("/")->policy;
  EXPECT_TRUE(policy.starts_with("default-src 'none'"));
  for (const char* loose : {"unsafe", "*", "http"}) EXPECT_EQ(policy.find(loose), std::string_view::npos) << loose;
}

}  // namespace
}  // namespace selvage::server::room
