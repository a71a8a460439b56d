#include "server/options.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

namespace selvage {
namespace {

std::variant<Options, Farewell> parse(std::initializer_list<const char*> words) {
  std::vector<const char*> argv{"selvaged"};
  argv.insert(argv.end(), words);
  return parse_options(static_cast<int>(argv.size()), argv.data());
}

TEST(Options, Defaults) {
  const auto parsed = parse({});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options);
  EXPECT_EQ(options->host, "127.0.0.1");
  EXPECT_EQ(options->port, 7171);
  EXPECT_GE(options->workers, 1U);
}

TEST(Options, AreRead) {
  const auto parsed = parse({"--listen", "[::1]:0", "--workers", "0", "--cache-mb", "8", "--max-body-mb", "3",
                             "--port-file", "p", "--log-level", "warn"});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options);
  EXPECT_EQ(options->host, "::1");
  EXPECT_EQ(options->port, 0);
  EXPECT_EQ(options->workers, 0U);
  EXPECT_EQ(options->cache_mb, 8U);
  EXPECT_EQ(options->limits.transport.body_bytes, 3U << 20);
  EXPECT_EQ(options->port_file, "p");
  EXPECT_EQ(options->log_level, "warn");
}

TEST(Options, LoopbackOnly) {
  for (const auto* address : {"0.0.0.0:7171", "192.168.1.2:80", "example.com:80", "[::]:7171", ":7171"}) {
    const auto parsed = parse({"--listen", address});
    const auto* farewell = std::get_if<Farewell>(&parsed);
    ASSERT_TRUE(farewell) << address;
    EXPECT_EQ(farewell->exit_code, 2);
    EXPECT_NE(farewell->text.find("not a loopback address"), std::string::npos) << farewell->text;
  }
}

TEST(Options, MistakesAreRefused) {
  for (const auto& words : std::initializer_list<std::initializer_list<const char*>>{{"--listen", "127.0.0.1"},
                                                                                     {"--listen", "127.0.0.1:"},
                                                                                     {"--listen", "127.0.0.1:65536"},
                                                                                     {"--listen", "127.0.0.1:80x"},
                                                                                     {"--workers", "-1"},
                                                                                     {"--workers", "many"},
                                                                                     {"--cache-mb", "0"},
                                                                                     {"--log-level", "loud"},
                                                                                     {"--nonsense"}}) {
    const auto parsed = parse(words);
    const auto* farewell = std::get_if<Farewell>(&parsed);
    ASSERT_TRUE(farewell) << *words.begin();
    EXPECT_EQ(farewell->exit_code, 2);
    EXPECT_FALSE(farewell->text.empty());
  }
}

TEST(Options, VersionIsNoMistake) {
  const auto parsed = parse({"--version"});
  const auto* farewell = std::get_if<Farewell>(&parsed);
  ASSERT_TRUE(farewell);
  EXPECT_EQ(farewell->exit_code, 0);
  EXPECT_EQ(farewell->text.rfind("selvaged ", 0), 0U);
}

}  // namespace
}  // namespace selvage
