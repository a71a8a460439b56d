#include "clients/cpp/address.h"

#include <gtest/gtest.h>

namespace selvage::client {
namespace {

TEST(Address, IsATcpAddressOrAPath) {
  EXPECT_EQ(read_address("localhost:7171")->host, "localhost");
  EXPECT_EQ(read_address("localhost:7171")->port, "7171");
  EXPECT_EQ(read_address("[::1]:80")->host, "::1");
  EXPECT_EQ(read_address("/run/selvage.sock")->path, "/run/selvage.sock");
  EXPECT_EQ(read_address("unix:s")->path, "s");
  EXPECT_FALSE(read_address("localhost:7171")->tls);
  EXPECT_TRUE(read_address("tls://[::1]:7171")->tls);
  EXPECT_EQ(read_address("tls://[::1]:7171")->host, "::1");
}

TEST(Address, RejectsEverythingElse) {
  for (const char* text : {"", "7171", ":7171", "host:", "host:0", "host:65536", "host:1x", "::1:80", "unix:",
                           "http://host:80", "tls://", "tls://host", "tls:///run/selvage.sock", "tls://unix:s"}) {
    EXPECT_FALSE(read_address(text)) << text;
  }
  EXPECT_FALSE(read_address("/" + std::string(200, 'x')));
}

}  // namespace
}  // namespace selvage::client
