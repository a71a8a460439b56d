#include "server/app/options.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <string>
#include <vector>

#include "tests/server/store/temporary_folder.h"

namespace selvage::server::app {
namespace {

std::variant<Options, EarlyExit> parse(std::initializer_list<const char*> arguments) {
  std::vector<const char*> argv{"selvaged"};
  argv.insert(argv.end(), arguments);
  return parse_options(static_cast<int>(argv.size()), argv.data());
}

TEST(Options, Defaults) {
  const auto parsed = parse({});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options);
  EXPECT_EQ(options->host, "127.0.0.1");
  EXPECT_EQ(options->port, 7171);
  EXPECT_GE(options->workers, 1U);
  EXPECT_EQ(options->real_time, RealTime::kAuto);
}

TEST(Options, AreRead) {
  const auto parsed = parse({"--listen", "[::1]:0", "--workers", "0", "--cache-mb", "8", "--max-body-mb", "3",
                             "--call-seconds", "90", "--port-file", "p", "--log-level", "warn", "--real-time", "on"});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options);
  EXPECT_EQ(options->host, "::1");
  EXPECT_EQ(options->port, 0);
  EXPECT_EQ(options->workers, 0U);
  EXPECT_EQ(options->cache_bytes, 8U << 20);
  EXPECT_EQ(options->limits.transport.body_bytes, 3U << 20);
  EXPECT_EQ(options->limits.call, std::chrono::seconds{90});
  EXPECT_EQ(options->port_file, "p");
  EXPECT_EQ(options->log.level, "warn");
  EXPECT_EQ(options->real_time, RealTime::kOn);
  EXPECT_EQ(options->log.format, ops::LogFormat::kText);
}

TEST(Options, TheMemoryIsDivided) {
  const calls::Limits as_built;
  const auto standard = std::get<Options>(parse({}));
  EXPECT_EQ(standard.cache_bytes, Options{}.cache_bytes);
  EXPECT_EQ(standard.limits.transport.traffic_bytes, as_built.transport.traffic_bytes);
  EXPECT_EQ(standard.limits.markers_bytes, as_built.markers_bytes);
  const auto small = std::get<Options>(parse({"--memory", "512", "--traffic-mb", "100"}));
  EXPECT_EQ(small.cache_bytes, 64U << 20);
  EXPECT_EQ(small.limits.transport.traffic_bytes, 100U << 20);
  EXPECT_EQ(small.limits.markers_bytes, std::size_t{300} << 20);
}

TEST(Options, TheLogMayBeWrittenAsJson) {
  EXPECT_EQ(std::get<Options>(parse({"--log-format", "json"})).log.format, ops::LogFormat::kJson);
}

TEST(Options, RealTimePrioritiesMayBeDeclined) {
  const auto of = [](std::initializer_list<const char*> arguments) {
    return std::get<Options>(parse(arguments)).real_time;
  };
  EXPECT_EQ(of({"--real-time", "off"}), RealTime::kOff);
  EXPECT_EQ(of({"--real-time", "auto"}), RealTime::kAuto);
  EXPECT_EQ(of({"--real-time", "--workers", "2"}), RealTime::kAuto);
}

TEST(Options, AConfigurationMaySayTrueOrFalse) {
  const test::TemporaryFolder folder;
  const auto of = [&folder](const std::string& value) {
    const std::string file = folder.write("selvaged.toml", "real-time = " + value + "\n");
    return std::get<Options>(parse({"--config", file.c_str()})).real_time;
  };
  EXPECT_EQ(of("true"), RealTime::kOn);
  EXPECT_EQ(of("false"), RealTime::kOff);
  EXPECT_EQ(of("\"off\""), RealTime::kOff);
}

// The error message for these options.
std::string refusal(std::initializer_list<const char*> arguments) {
  const auto parsed = parse(arguments);
  const auto* early_exit = std::get_if<EarlyExit>(&parsed);
  if (early_exit == nullptr) return "not refused";
  EXPECT_EQ(early_exit->code, 2);
  return early_exit->text;
}

TEST(Options, MemoryThatLeavesNothingForMarkersIsRefused) {
  EXPECT_NE(refusal({"--memory", "64"}).find("--memory 64"), std::string::npos);
  EXPECT_NE(refusal({"--memory", "512", "--cache-mb", "500"}).find("--memory 512"), std::string::npos);
}

TEST(Options, ARefusedWordIsNamedWithThoseThatAreAllowed) {
  EXPECT_NE(refusal({"--real-time", "maybe"}).find("--real-time: maybe not in {auto,on,off}"), std::string::npos);
}

class ExposedOptions : public ::testing::Test {
 protected:
  const test::TemporaryFolder folder_;
  const std::string token_{folder_.write("token", "correct horse battery\nsecond line\n")};
};

TEST_F(ExposedOptions, TheErrorNamesTheMissingOption) {
  const char* token = token_.c_str();
  const auto misses = [](const std::string& text, const std::string& option) {
    return text.find("can be reached by other machines: " + option) != std::string::npos;
  };
  for (const auto* address : {"0.0.0.0:7171", "192.168.1.2:80", "[::]:7171"}) {
    EXPECT_TRUE(misses(refusal({"--listen", address}), "--token-file is missing")) << address;
    EXPECT_TRUE(misses(refusal({"--listen-tcp", address}), "--token-file is missing")) << address;
    EXPECT_TRUE(misses(refusal({"--listen", address, "--token-file", token}), "--tls-cert and --tls-key are missing"));
    EXPECT_TRUE(misses(refusal({"--listen", address, "--behind-proxy"}), "--token-file is missing"));
  }
  EXPECT_NE(refusal({"--tls-cert", "c"}).find("--tls-key"), std::string::npos);
  EXPECT_NE(refusal({"--tls-key", "k"}).find("--tls-cert"), std::string::npos);
  EXPECT_NE(refusal({"--no-token"}).find("--behind-proxy"), std::string::npos);
  EXPECT_NE(refusal({"--no-token", "--behind-proxy", "--token-file", token}).find("exclude"), std::string::npos);
}

TEST_F(ExposedOptions, AreAcceptedWhenComplete) {
  for (const auto& arguments : std::initializer_list<std::initializer_list<const char*>>{
           {"--listen", "0.0.0.0:0", "--token-file", token_.c_str(), "--tls-cert", "c", "--tls-key", "k"},
           {"--listen", "0.0.0.0:0", "--token-file", token_.c_str(), "--behind-proxy"},
           {"--listen", "0.0.0.0:0", "--no-token", "--behind-proxy"},
           {"--listen", "127.0.0.5:0"}}) {
    const auto parsed = parse(arguments);
    const auto* options = std::get_if<Options>(&parsed);
    ASSERT_TRUE(options) << *(arguments.begin() + 1);
  }
  const auto parsed = parse({"--token-file", token_.c_str()});
  EXPECT_EQ(std::get<Options>(parsed).access.token, "correct horse battery");
}

TEST_F(ExposedOptions, TheTokenFileMustExistAndTheTokenBeLongEnough) {
  EXPECT_NE(refusal({"--token-file", folder_.file("none").c_str()}).find("cannot read"), std::string::npos);
  EXPECT_NE(refusal({"--token-file", folder_.write("short", "123\n").c_str()}).find("too short"), std::string::npos);
  EXPECT_NE(refusal({"--token-file", folder_.write("empty", "").c_str()}).find("cannot read"), std::string::npos);
}

TEST(Options, ConnectionsPerAddressAreThreeQuartersUnlessAProxyHasThemAll) {
  const auto limit = [](std::initializer_list<const char*> arguments) {
    return std::get<Options>(parse(arguments)).limits.transport.connections_per_address;
  };
  EXPECT_EQ(limit({}), 384U);
  EXPECT_EQ(limit({"--max-connections", "2"}), 2U);
  EXPECT_EQ(limit({"--behind-proxy"}), 512U);
  EXPECT_EQ(limit({"--behind-proxy", "--max-connections-per-address", "7"}), 7U);
}

TEST(Options, HealthMayBeServedToOtherMachinesWithoutToken) {
  const auto parsed = parse({"--listen-health", "0.0.0.0:9000"});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options);
  EXPECT_EQ(listen_settings(*options).listeners.back().speaks, transport::access::Listener::Speaks::kHealth);
  EXPECT_EQ(listen_settings(*options).listeners.back().port, 9000);
  EXPECT_NE(refusal({"--listen-health", "9000"}).find("--listen-health"), std::string::npos);
}

TEST(Options, ListenersAreListedHttpFirst) {
  const auto parsed = parse({"--listen-unix", "/run/s", "--listen-tcp", "127.0.0.1:1", "--listen-tcp", "[::1]:2"});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options);
  const transport::access::ListenSettings listen = listen_settings(*options);
  ASSERT_EQ(listen.listeners.size(), 4U);
  EXPECT_EQ(listen.listeners[0].speaks, transport::access::Listener::Speaks::kHttp);
  EXPECT_EQ(listen.listeners[0].port, 7171);
  EXPECT_EQ(listen.listeners[1].port, 1);
  EXPECT_EQ(listen.listeners[2].host, "::1");
  EXPECT_EQ(listen.listeners[3].path, "/run/s");
}

TEST(Options, TheCommandLineOverridesTheFile) {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("selvaged.toml",
                                        "# how this machine serves\n"
                                        "listen = \"127.0.0.1:9000\"\n"
                                        "listen-tcp = [\"127.0.0.1:1\", \"127.0.0.1:2\"]\n"
                                        "workers = 3\n"
                                        "behind-proxy = true\n"
                                        "no-token = true\n"
                                        "log-level = \"warn\"\n");
  const auto parsed = parse({"--config", file.c_str(), "--workers", "2"});
  const auto* options = std::get_if<Options>(&parsed);
  ASSERT_TRUE(options) << std::get<EarlyExit>(parsed).text;
  EXPECT_EQ(options->port, 9000);
  EXPECT_EQ(options->listeners.size(), 2U);
  EXPECT_EQ(options->workers, 2U);
  EXPECT_EQ(options->log.level, "warn");
}

TEST(Options, AFileWithErrorsIsRefused) {
  const test::TemporaryFolder folder;
  for (const auto* text : {"nonsense = 1\n", "workers = many\n", "listen = \"0.0.0.0:1\"\n", "check = \"x.json\"\n"}) {
    EXPECT_NE(refusal({"--config", folder.write("f", text).c_str()}), "not refused") << text;
  }
  EXPECT_NE(refusal({"--config", folder.file("missing").c_str()}), "not refused");
}

TEST(Options, Tasks) {
  EXPECT_EQ(std::get<Options>(parse({})).task, Options::Task::kServe);
  EXPECT_EQ(std::get<Options>(parse({"--check-config"})).task, Options::Task::kCheckConfig);
  const Options replay = std::get<Options>(parse({"--check", "calls.json", "--svg", "out.svg"}));
  EXPECT_EQ(replay.task, Options::Task::kReplay);
  EXPECT_EQ(replay.replay_file, "calls.json");
  EXPECT_EQ(replay.replay_svg, "out.svg");
  EXPECT_NE(refusal({"--svg", "out.svg"}), "not refused");
}

TEST(Options, ErrorsAreRefused) {
  for (const auto& arguments :
       std::initializer_list<std::initializer_list<const char*>>{{"--listen", "127.0.0.1"},
                                                                 {"--listen", "127.0.0.1:"},
                                                                 {"--listen", "127.0.0.1:65536"},
                                                                 {"--listen", "127.0.0.1:80x"},
                                                                 {"--workers", "-1"},
                                                                 {"--workers", "many"},
                                                                 {"--cache-mb", "0"},
                                                                 {"--log-level", "loud"},
                                                                 {"--log-format", "xml"},
                                                                 {"--listen", "example.com:80"},
                                                                 {"--listen", ":7171"},
                                                                 {"--listen-tcp", "::1:7171"},
                                                                 {"--drain-seconds", "-1"},
                                                                 {"--call-seconds", "0"},
                                                                 {"--nonsense"}}) {
    const auto parsed = parse(arguments);
    const auto* early_exit = std::get_if<EarlyExit>(&parsed);
    ASSERT_TRUE(early_exit) << *arguments.begin();
    EXPECT_EQ(early_exit->code, 2);
    EXPECT_FALSE(early_exit->text.empty());
  }
}

TEST(Options, VersionExitsWithCode0) {
  const auto parsed = parse({"--version"});
  const auto* early_exit = std::get_if<EarlyExit>(&parsed);
  ASSERT_TRUE(early_exit);
  EXPECT_EQ(early_exit->code, 0);
  EXPECT_EQ(early_exit->text.rfind("selvaged ", 0), 0U);
}

}  // namespace
}  // namespace selvage::server::app
