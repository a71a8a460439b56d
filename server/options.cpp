#include "server/options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <string_view>
#include <thread>

#include "server/version.h"

namespace selvage {
namespace {

// "127.0.0.1:7171", "[::1]:7171", "localhost:7171" into host and port; the reason when it is none of these.
std::optional<std::string> read_address(std::string_view text, Options& options) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return "expected HOST:PORT, such as 127.0.0.1:7171";
  std::string_view host = text.substr(0, colon);
  const std::string_view port = text.substr(colon + 1);
  const auto [end, mistake] = std::from_chars(port.data(), port.data() + port.size(), options.port);
  if (port.empty() || mistake != std::errc{} || end != port.data() + port.size()) {
    return "the port must be a number from 0 to 65535, not '" + std::string{port} + "'";
  }
  if (host == "localhost") host = "127.0.0.1";
  if (host == "[::1]") host = "::1";
  if (host != "127.0.0.1" && host != "::1") {
    return "'" + std::string{host} +
           "' is not a loopback address; until TLS and tokens are there, selvaged listens on 127.0.0.1, "
           "[::1] or "
           "localhost only";
  }
  options.host = host;
  return std::nullopt;
}

}  // namespace

std::variant<Options, Farewell> parse_options(int argc, const char* const* argv) {
  Options options;
  options.workers = std::max(1U, std::thread::hardware_concurrency());
  std::string listen = "127.0.0.1:7171";
  std::size_t body_mb = options.limits.transport.body_bytes >> 20;

  CLI::App app{"selvaged: compacts garment markers, by JSON-RPC 2.0 over HTTP or over lines of JSON.", "selvaged"};
  app.set_version_flag("--version", "selvaged " + std::string{kVersion});
  app.add_option("--listen", listen, "HOST:PORT of a loopback address; port 0 takes a free one")->capture_default_str();
  app.add_option("--port-file", options.port_file, "Write the port that was taken into this file");
  app.add_option("--workers", options.workers, "Threads for motions; 0 runs them on the I/O thread, for tests")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  app.add_option("--cache-mb", options.cache_mb, "Memory for Minkowski sums, in MiB")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("--max-body-mb", body_mb, "The largest request, in MiB")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--store", options.store,
                 "The file that keeps markers over restarts (SQLite); none: they live in memory only")
      ->default_str("none");
  std::string durability = "full";
  app.add_option("--durability", durability,
                 "full: an acknowledged change outlives the loss of power; relaxed: the end of the process")
      ->check(CLI::IsMember({"full", "relaxed"}))
      ->capture_default_str();
  app.add_option("--log-level", options.log_level, "What is logged to stderr")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& told) {
    std::ostringstream out;
    std::ostringstream err;
    const int exit_code = app.exit(told, out, err);
    return Farewell{exit_code == 0 ? 0 : 2, out.str() + err.str()};
  }
  if (const auto mistake = read_address(listen, options)) return Farewell{2, "--listen: " + *mistake + "\n"};
  options.limits.transport.body_bytes = body_mb << 20;
  if (options.store == "none") options.store.clear();
  options.durability = durability == "relaxed" ? Durability::kRelaxed : Durability::kFull;
  return options;
}

}  // namespace selvage
