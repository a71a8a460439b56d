#include "server/app/options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "server/app/addresses.h"
#include "server/calls/version.h"

namespace selvage::server::app {
namespace {

constexpr std::size_t kShortestToken = 16;

// The words as they were written, before they are options.
struct Words {
  std::string listen{"127.0.0.1:7171"};
  std::vector<std::string> listen_tcp, listen_unix;
  std::string token_file;
  transport::access::TlsFiles tls;
  bool behind_proxy{}, no_token{}, check_config{};
  std::size_t body_mb{};
  std::int64_t call_seconds{}, drain_seconds{};
  std::string durability{"full"};
};

using Mistake = std::optional<std::string>;  // what is wrong, for stderr

void declare_doors(CLI::App& app, Options& options, Words& words) {
  app.add_option("--listen", words.listen, "HOST:PORT for HTTP, WebSocket and lines of JSON; port 0 takes a free one")
      ->capture_default_str();
  app.add_option("--listen-tcp", words.listen_tcp, "HOST:PORT for lines of JSON only; may be repeated");
  app.add_option("--listen-unix", words.listen_unix,
                 "Path of a socket for lines of JSON, open to this user only; may be repeated");
  app.add_option("--port-file", options.port_file, "Write the ports that were taken into this file, HTTP's first");
  app.add_option("--token-file", words.token_file, "A file whose first line every TCP connection must show");
  app.add_option("--tls-cert", words.tls.certificate, "Certificate chain (PEM): all TCP speaks TLS");
  app.add_option("--tls-key", words.tls.key, "Its private key (PEM)");
  app.add_flag("--behind-proxy", words.behind_proxy,
               "Plain TCP although other machines reach the address: a proxy in front of it speaks TLS");
  app.add_flag("--no-token", words.no_token, "With --behind-proxy: the proxy knows who may call");
  app.add_option("--allow-host", options.access.hosts,
                 "A name that clients call this server by, for requests without a token; may be repeated");
  app.add_option("--allow-origin", options.access.origins,
                 "An origin whose pages may call, such as https://marker.example; may be repeated");
}

void declare_work(CLI::App& app, Options& options, Words& words) {
  app.add_option("--workers", options.workers, "Threads for motions; 0 runs them on the I/O thread, for tests")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  app.add_option("--cache-mb", options.cache_mb, "Memory for Minkowski sums, in MiB")
      ->check(CLI::Range(1, 1 << 20))
      ->capture_default_str();
  app.add_option("--max-body-mb", words.body_mb, "The largest request, in MiB")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--max-connections", options.limits.transport.connections, "Open at once")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--call-seconds", words.call_seconds,
                 "A motion that has taken so long, its waiting included, answers with its best; a read that may take "
                 "as long is refused")
      ->check(CLI::Range(1, 86'400))
      ->capture_default_str();
  app.add_option("--store", options.store,
                 "The file that keeps markers over restarts (SQLite); none: they live in memory only")
      ->default_str("none");
  app.add_option("--durability", words.durability,
                 "full: an acknowledged change outlives the loss of power; relaxed: the end of the process")
      ->check(CLI::IsMember({"full", "relaxed"}))
      ->capture_default_str();
  app.add_option("--log-level", options.log_level, "What is logged")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  app.add_option("--log", options.log_file, "The file to log to, opened anew on SIGHUP; stderr without it");
  app.add_option("--drain-seconds", words.drain_seconds, "How long ending may take after SIGTERM or SIGINT")
      ->check(CLI::Range(0, 3600))
      ->capture_default_str();
}

void declare_tasks(CLI::App& app, Options& options, Words& words) {
  // On the command line only: a file that names another file, or says not to serve, would be a riddle.
  app.set_config("--config", "", "Read options from this TOML file; the command line comes first");
  app.add_flag("--check-config", words.check_config, "Say whether the options and files are sound, and end")
      ->configurable(false);
  app.add_option("--check", options.replay_file,
                 "Answer the JSON-RPC call of this file, or each of its array in order, without sockets, and end")
      ->configurable(false);
  app.add_option("--svg", options.replay_svg, "With --check: draw the marker that is open in the end into this file")
      ->needs("--check")
      ->configurable(false);
}

Mistake read_token(const std::string& path, std::string& token) {
  std::ifstream file{path};
  if (!file || !std::getline(file, token)) return "--token-file: cannot read " + path;
  while (!token.empty() && (token.back() == '\r' || token.back() == ' ')) token.pop_back();
  if (token.size() >= kShortestToken) return std::nullopt;
  return "--token-file: the first line of " + path + " is too short; " + std::to_string(kShortestToken) +
         " characters at least";
}

Mistake read_doors(const Words& words, Options& options) {
  const auto http = read_address(words.listen);
  if (const auto* wrong = std::get_if<std::string>(&http)) return "--listen: " + *wrong;
  options.host = std::get<TcpAddress>(http).host;
  options.port = std::get<TcpAddress>(http).port;
  for (const std::string& text : words.listen_tcp) {
    const auto address = read_address(text);
    if (const auto* wrong = std::get_if<std::string>(&address)) return "--listen-tcp: " + *wrong;
    const auto& [host, port] = std::get<TcpAddress>(address);
    options.listeners.push_back({.speaks = transport::access::Listener::Speaks::kLines, .host = host, .port = port});
  }
  for (const std::string& path : words.listen_unix) {
    options.listeners.push_back({.speaks = transport::access::Listener::Speaks::kLines, .path = path});
  }
  if (words.tls.certificate.empty() != words.tls.key.empty()) {
    return words.tls.key.empty() ? "--tls-cert needs --tls-key" : "--tls-key needs --tls-cert";
  }
  if (!words.tls.key.empty()) options.tls = words.tls;
  if (words.no_token && !words.behind_proxy) return "--no-token needs --behind-proxy";
  if (words.no_token && !words.token_file.empty()) return "--no-token and --token-file exclude each other";
  return words.token_file.empty() ? std::nullopt : read_token(words.token_file, options.access.token);
}

// Other machines may reach an address only when they show a token and nobody in between can read it.
Mistake exposed(const Words& words, const Options& options) {
  for (const transport::access::Listener& listener : doors_of(options).listeners) {
    if (!listener.path.empty() || is_loopback(listener.host)) continue;
    const std::string reached = address_text({listener.host, listener.port}) + " is reached by other machines: ";
    if (options.access.token.empty() && !words.no_token) return reached + "--token-file is missing";
    if (!options.tls && !words.behind_proxy) {
      return reached + "--tls-cert and --tls-key are missing (or --behind-proxy, if a proxy speaks TLS for it)";
    }
  }
  return std::nullopt;
}

Mistake settle(const Words& words, Options& options) {
  if (auto mistake = read_doors(words, options)) return mistake;
  if (auto mistake = exposed(words, options)) return mistake;
  options.limits.transport.body_bytes = words.body_mb << 20;
  options.limits.call = std::chrono::seconds{words.call_seconds};
  options.drain = std::chrono::seconds{words.drain_seconds};
  if (options.store == "none") options.store.clear();
  options.durability = words.durability == "relaxed" ? store::Durability::kRelaxed : store::Durability::kFull;
  if (!options.replay_file.empty()) options.task = Options::Task::kReplay;
  if (words.check_config) options.task = Options::Task::kCheckConfig;
  return std::nullopt;
}

}  // namespace

transport::access::Doors doors_of(const Options& options) {
  transport::access::Doors doors{.access = options.access, .tls = options.tls};
  doors.listeners.push_back(
      {.speaks = transport::access::Listener::Speaks::kHttp, .host = options.host, .port = options.port});
  doors.listeners.insert(doors.listeners.end(), options.listeners.begin(), options.listeners.end());
  return doors;
}

std::variant<Options, Farewell> parse_options(int argc, const char* const* argv) {
  Options options;
  options.workers = std::max(1U, std::thread::hardware_concurrency());
  Words words;
  words.body_mb = options.limits.transport.body_bytes >> 20;
  words.call_seconds = std::chrono::duration_cast<std::chrono::seconds>(options.limits.call).count();
  words.drain_seconds = options.drain.count();

  CLI::App app{"selvaged: compacts garment markers, by JSON-RPC 2.0 over HTTP, WebSocket or lines of JSON.",
               "selvaged"};
  app.set_version_flag("--version", "selvaged " + std::string{calls::kVersion});
  app.allow_config_extras(CLI::config_extras_mode::error);
  declare_doors(app, options, words);
  declare_work(app, options, words);
  declare_tasks(app, options, words);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& told) {
    std::ostringstream out;
    std::ostringstream err;
    const int exit_code = app.exit(told, out, err);
    return Farewell{exit_code == 0 ? 0 : 2, out.str() + err.str()};
  }
  if (const auto mistake = settle(words, options)) return Farewell{2, *mistake + "\n"};
  return options;
}

}  // namespace selvage::server::app
