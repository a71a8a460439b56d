#include "server/app/options.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <exception>
#include <map>
#include <sstream>
#include <string_view>
#include <thread>
#include <utility>

#include "server/app/addresses.h"
#include "server/app/authentication.h"
#include "server/memory/budget.h"
#include "server/ops/version.h"

namespace selvage::server::app {
namespace {

// Options as they were written, before they are checked and converted.
struct RawOptions {
  std::string listen{"127.0.0.1:7171"};
  std::vector<std::string> listen_tcp, listen_unix;
  transport::access::TlsFiles tls;
  bool behind_proxy{}, no_token{}, check_config{}, verify_store{};
  std::string listen_health;
  std::size_t body_mb{}, memory_mb{2048};
  std::optional<std::size_t> cache_mb, traffic_mb, connections_per_address;
  std::int64_t call_seconds{}, drain_seconds{};
  std::string durability{"full"}, real_time{"auto"};
  std::string log_format{"text"};
};

using OptionError = std::optional<std::string>;  // a message for stderr

void declare_listeners(CLI::App& app, Options& options, RawOptions& raw) {
  app.add_option("--listen", raw.listen,
                 "HOST:PORT for HTTP, WebSocket and lines of JSON; port 0 selects any free port")
      ->capture_default_str();
  app.add_option("--listen-tcp", raw.listen_tcp, "HOST:PORT for lines of JSON only; may be repeated");
  app.add_option("--listen-unix", raw.listen_unix,
                 "Path of a Unix socket for lines of JSON, open to this user only; may be repeated");
  app.add_option(
      "--listen-health", raw.listen_health,
      "HOST:PORT for health checks: plain HTTP GET of /healthz and /readyz without token, outside all limits");
  app.add_option("--port-file", options.port_file, "Write the actual ports to this file, HTTP first");
  app.add_option("--token-file", options.token_file,
                 "A file whose first line is the token that every TCP connection must send");
  app.add_option("--tls-cert", raw.tls.certificate, "Certificate chain (PEM); enables TLS on every TCP listener");
  app.add_option("--tls-key", raw.tls.key, "Private key of the certificate (PEM)");
  app.add_flag("--behind-proxy", raw.behind_proxy,
               "Allow plain TCP on an address that other machines can reach, because a proxy terminates TLS");
  app.add_flag("--no-token", raw.no_token,
               "With --behind-proxy: require no token, because the proxy decides who may call");
  app.add_option("--allow-host", options.access.hosts,
                 "Another host name of this server, for requests without a token; may be repeated");
  app.add_option("--allow-origin", options.access.origins,
                 "An origin whose pages may call, such as https://marker.example; may be repeated");
}

void declare_threads(CLI::App& app, Options& options, RawOptions& raw) {
  app.add_option("--workers", options.workers, "Threads for motions; 0 executes them on the I/O thread, for tests")
      ->check(CLI::Range(0, 256))
      ->capture_default_str();
  app.add_option(
         "--real-time", raw.real_time,
         "Real-time priorities for the threads that all clients wait for, if the system allows them. auto, or "
         "no value: while any of them waits for a processor; on: always, and the log warns if the system allows "
         "none; off: never")
      ->transform(
          CLI::Transformer(std::map<std::string, std::string>{{"true", "on"}, {"false", "off"}}).description(""))
      ->check(CLI::IsMember({"auto", "on", "off"}))
      ->expected(0, 1)
      ->capture_default_str();
}

void declare_memory(CLI::App& app, RawOptions& raw) {
  app.add_option("--memory", raw.memory_mb,
                 "Memory in MiB for the program itself and for everything that clients can make grow: Minkowski sums, "
                 "requests and answers; the rest is for markers, their histories and the answers kept for retries")
      ->check(CLI::Range(64, 1 << 24))
      ->capture_default_str();
  app.add_option("--cache-mb", raw.cache_mb,
                 "The part of --memory for Minkowski sums, in MiB; by default an eighth, at most 256")
      ->check(CLI::Range(1, 1 << 20));
  app.add_option("--max-body-mb", raw.body_mb, "Maximum size of a request, in MiB")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  app.add_option("--traffic-mb", raw.traffic_mb,
                 "The part of --memory for requests being received or answered and for answers not yet sent, in MiB; "
                 "by default a quarter, at most 512")
      ->check(CLI::Range(1, 1 << 20));
}

void declare_limits(CLI::App& app, Options& options, RawOptions& raw) {
  app.add_option("--max-connections", options.limits.transport.connections, "Maximum number of open connections")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option(
         "--max-connections-per-address", raw.connections_per_address,
         "Maximum number of these from one address; by default three quarters, or with --behind-proxy all of them")
      ->check(CLI::Range(1, 100'000));
  app.add_option(
         "--call-seconds", raw.call_seconds,
         "Time limit of a call, including waiting: a motion then returns its best result so far, a long read fails")
      ->check(CLI::Range(1, 86'400))
      ->capture_default_str();
  app.add_option("--drain-seconds", raw.drain_seconds, "Time limit for shutting down after SIGTERM or SIGINT")
      ->check(CLI::Range(0, 3600))
      ->capture_default_str();
}

void declare_store(CLI::App& app, Options& options, RawOptions& raw) {
  app.add_option("--store", options.store,
                 "The file (SQLite) in which markers survive restarts; without it they are kept in memory only")
      ->default_str("none");
  app.add_option(
         "--durability", raw.durability,
         "full: an acknowledged change survives a power failure; relaxed: it survives only an end of the process")
      ->check(CLI::IsMember({"full", "relaxed"}))
      ->capture_default_str();
}

void declare_log(CLI::App& app, Options& options, RawOptions& raw) {
  app.add_option("--log-level", options.log.level, "The least severe messages that are logged")
      ->check(CLI::IsMember({"debug", "info", "warn", "error", "off"}))
      ->capture_default_str();
  app.add_option("--log", options.log.file, "The log file, reopened on SIGHUP; without it the log goes to stderr");
  app.add_option("--log-format", raw.log_format, "text, or json with one object per line")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
}

void declare_tasks(CLI::App& app, Options& options, RawOptions& raw) {
  // On the command line only: a configuration file that names another one, or disables serving, would be confusing.
  app.set_config("--config", "", "Read options from this TOML file; the command line takes precedence");
  app.add_flag("--check-config", raw.check_config, "Check the options and files, and exit")->configurable(false);
  app.add_option("--check", options.replay_file,
                 "Answer the JSON-RPC call in this file, or each call of an array in order, without sockets, and exit")
      ->configurable(false);
  app.add_option("--svg", options.replay_svg, "With --check: draw the marker that is open at the end into this file")
      ->needs("--check")
      ->configurable(false);
  app.add_flag("--verify-store", raw.verify_store,
               "Check every row of the --store, which no daemon may be using, and exit")
      ->configurable(false);
  app.add_option("--backup", options.backup_file,
                 "Copy the --store to this file, also while a daemon is using it, check the copy, and exit")
      ->configurable(false);
}

OptionError read_listeners(const RawOptions& raw, Options& options) {
  const auto http = read_address(raw.listen);
  if (const auto* wrong = std::get_if<std::string>(&http)) return "--listen: " + *wrong;
  options.host = std::get<TcpAddress>(http).host;
  options.port = std::get<TcpAddress>(http).port;
  for (const std::string& text : raw.listen_tcp) {
    const auto address = read_address(text);
    if (const auto* wrong = std::get_if<std::string>(&address)) return "--listen-tcp: " + *wrong;
    const auto& [host, port] = std::get<TcpAddress>(address);
    options.listeners.push_back({.speaks = transport::access::Listener::Speaks::kLines, .host = host, .port = port});
  }
  for (const std::string& path : raw.listen_unix) {
    options.listeners.push_back({.speaks = transport::access::Listener::Speaks::kLines, .path = path});
  }
  if (!raw.listen_health.empty()) {
    const auto address = read_address(raw.listen_health);
    if (const auto* wrong = std::get_if<std::string>(&address)) return "--listen-health: " + *wrong;
    const auto& [host, port] = std::get<TcpAddress>(address);
    options.listeners.push_back({.speaks = transport::access::Listener::Speaks::kHealth, .host = host, .port = port});
  }
  if (raw.tls.certificate.empty() != raw.tls.key.empty()) {
    return raw.tls.key.empty() ? "--tls-cert needs --tls-key" : "--tls-key needs --tls-cert";
  }
  if (!raw.tls.key.empty()) options.tls = raw.tls;
  if (raw.no_token && !raw.behind_proxy) return "--no-token needs --behind-proxy";
  if (raw.no_token && !options.token_file.empty()) return "--no-token and --token-file exclude each other";
  try {
    if (!options.token_file.empty()) options.access.token = read_token(options.token_file);
  } catch (const std::exception& error) {
    return error.what();
  }
  return std::nullopt;
}

// An address that other machines can reach requires a token, and TLS so that nobody can read it on the way.
OptionError check_exposure(const RawOptions& raw, const Options& options) {
  for (const transport::access::Listener& listener : listen_settings(options).listeners) {
    const bool health = listener.speaks == transport::access::Listener::Speaks::kHealth;  // reveals nothing more
    if (!listener.path.empty() || is_loopback(listener.host) || health) continue;
    const std::string reached = address_text({listener.host, listener.port}) + " can be reached by other machines: ";
    if (options.access.token.empty() && !raw.no_token) return reached + "--token-file is missing";
    if (!options.tls && !raw.behind_proxy) {
      return reached + "--tls-cert and --tls-key are missing (or --behind-proxy, if a proxy terminates TLS)";
    }
  }
  return std::nullopt;
}

OptionError divide_memory(const RawOptions& raw, Options& options) {
  const auto bytes = [](const std::optional<std::size_t>& mb) { return mb ? std::optional{*mb << 20} : std::nullopt; };
  const auto budget = memory::divided(raw.memory_mb << 20, bytes(raw.cache_mb), bytes(raw.traffic_mb));
  if (!budget) {
    return "--memory " + std::to_string(raw.memory_mb) +
           ": sums, requests and answers (--cache-mb, --traffic-mb) leave too little of it for markers";
  }
  options.cache_bytes = budget->sums;
  options.limits.transport.traffic_bytes = budget->traffic;
  options.limits.markers_bytes = budget->markers;
  return std::nullopt;
}

RealTime real_time_of(const std::string& word) {
  if (word == "auto") return RealTime::kAuto;
  return word == "on" ? RealTime::kOn : RealTime::kOff;
}

OptionError convert(const RawOptions& raw, Options& options) {
  if (auto error = read_listeners(raw, options)) return error;
  if (auto error = check_exposure(raw, options)) return error;
  if (auto error = divide_memory(raw, options)) return error;
  options.limits.transport.body_bytes = raw.body_mb << 20;
  const std::size_t connections = options.limits.transport.connections;
  // Behind a proxy all connections have the proxy's address.
  options.limits.transport.connections_per_address =
      raw.connections_per_address.value_or(raw.behind_proxy ? connections : connections - connections / 4);
  options.limits.call = std::chrono::seconds{raw.call_seconds};
  options.drain = std::chrono::seconds{raw.drain_seconds};
  if (options.store == "none") options.store.clear();
  options.durability = raw.durability == "relaxed" ? store::Durability::kRelaxed : store::Durability::kFull;
  options.real_time = real_time_of(raw.real_time);
  options.log.format = raw.log_format == "json" ? ops::LogFormat::kJson : ops::LogFormat::kText;
  if (!options.replay_file.empty()) options.task = Options::Task::kReplay;
  if (raw.verify_store) options.task = Options::Task::kVerifyStore;
  if (!options.backup_file.empty()) options.task = Options::Task::kBackUp;
  const bool needs_store = raw.verify_store || !options.backup_file.empty();
  if (needs_store && options.store.empty()) return "--verify-store and --backup need --store";
  if (raw.check_config) options.task = Options::Task::kCheckConfig;
  return std::nullopt;
}

}  // namespace

transport::access::ListenSettings listen_settings(const Options& options) {
  transport::access::ListenSettings settings{.access = options.access, .tls = options.tls};
  settings.listeners.push_back(
      {.speaks = transport::access::Listener::Speaks::kHttp, .host = options.host, .port = options.port});
  settings.listeners.insert(settings.listeners.end(), options.listeners.begin(), options.listeners.end());
  return settings;
}

std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv) {
  Options options;
  options.workers = std::max(1U, std::thread::hardware_concurrency());
  RawOptions raw;
  raw.body_mb = options.limits.transport.body_bytes >> 20;
  raw.call_seconds = std::chrono::duration_cast<std::chrono::seconds>(options.limits.call).count();
  raw.drain_seconds = options.drain.count();

  CLI::App app{
      "selvaged: nests and compacts garment markers for clients that speak JSON-RPC 2.0 over HTTP, WebSocket or lines "
      "of JSON.",
      "selvaged"};
  app.set_version_flag("--version", "selvaged " + std::string{ops::kVersion});
  app.allow_config_extras(CLI::config_extras_mode::error);
  declare_listeners(app, options, raw);
  declare_threads(app, options, raw);
  declare_memory(app, raw);
  declare_limits(app, options, raw);
  declare_store(app, options, raw);
  declare_log(app, options, raw);
  declare_tasks(app, options, raw);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& parsed) {
    std::ostringstream out;
    std::ostringstream err;
    const int exit_code = app.exit(parsed, out, err);
    return EarlyExit{exit_code == 0 ? 0 : 2, out.str() + err.str()};
  }
  if (const auto error = convert(raw, options)) return EarlyExit{2, *error + "\n"};
  return options;
}

}  // namespace selvage::server::app
