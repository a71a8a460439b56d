#include "server/app/addresses.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

namespace selvage::server::app {
namespace {

TEST(Addresses, AreReadAndWritten) {
  for (const auto& [written, host, port] :
       {std::tuple{"127.0.0.1:7171", "127.0.0.1", 7171}, std::tuple{"[::1]:0", "::1", 0},
        std::tuple{"0.0.0.0:65535", "0.0.0.0", 65535}}) {
    const auto read = read_address(written);
    const auto* address = std::get_if<TcpAddress>(&read);
    ASSERT_TRUE(address) << written;
    EXPECT_EQ(address->host, host);
    EXPECT_EQ(address->port, port);
    EXPECT_EQ(address_text(*address), written);
  }
  EXPECT_EQ(std::get<TcpAddress>(read_address("localhost:1")).host, "127.0.0.1");
}

TEST(Addresses, WrongOnesAreRefusedWithAReason) {
  for (const auto* text : {"", ":", "127.0.0.1", "127.0.0.1:", "127.0.0.1:-1", "127.0.0.1:65536", "127.0.0.1:80x",
                           "::1:80", "[127.0.0.1]:80", "[::1:80", "example.com:80", "127.1:80", "[]:80"}) {
    const auto read = read_address(text);
    EXPECT_TRUE(std::holds_alternative<std::string>(read)) << text;
  }
}

TEST(Addresses, LoopbackIsRecognised) {
  for (const auto* host : {"127.0.0.1", "127.8.9.10", "::1"}) EXPECT_TRUE(is_loopback(host)) << host;
  for (const auto* host : {"0.0.0.0", "::", "128.0.0.1", "192.168.1.127", "::ffff:1.2.3.4"}) {
    EXPECT_FALSE(is_loopback(host)) << host;
  }
}

}  // namespace
}  // namespace selvage::server::app
