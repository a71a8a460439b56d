// The options of selvaged, from its command line or from a file with options of the same names.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "server/calls/limits.h"
#include "server/ops/log.h"
#include "server/store/journal.h"
#include "server/transport/access/listener.h"

namespace selvage::server::app {

// When the threads that all clients wait for have real-time priorities, if the system allows them.
enum class RealTime {
  kAuto,  // while any of them wakes up late
  kOn,    // always; the log warns if the system allows none
  kOff,
};

struct Options {
  enum class Task {
    kServe,
    kCheckConfig,  // report whether the options and files are valid
    kReplay,       // answer the calls of a file, without sockets
    kVerifyStore,  // check every row of the store
    kBackUp,       // copy the store, also while a daemon uses it
  };
  Task task{};
  std::string replay_file, replay_svg, backup_file;

  std::string host{"127.0.0.1"};                       // of the HTTP listener; a numeric address
  std::uint16_t port{7171};                            // 0: any free port
  std::vector<transport::access::Listener> listeners;  // further ones
  transport::access::Access access;
  std::string token_file;  // where the token is read again on SIGHUP; empty: there is none
  std::optional<transport::access::TlsFiles> tls;
  std::string port_file;  // receives the actual ports, one per line; empty: none
  std::size_t workers{};  // for motions; 0: inline, on the I/O thread (for tests)
  RealTime real_time{};
  std::size_t cache_bytes{std::size_t{256} << 20};  // for Minkowski sums
  std::string store;                                // the journal's file; empty: markers live in memory only
  store::Durability durability{};
  ops::LogSettings log;
  std::chrono::seconds drain{10};  // the longest time from the signal to the end
  calls::Limits limits;
};

// Every TCP port and Unix socket of these options, HTTP first.
[[nodiscard]] transport::access::ListenSettings listen_settings(const Options& options);

// The program is to exit immediately: --help, --version or an error.  `text` is for stdout if the code is 0, otherwise
// for stderr.
struct EarlyExit {
  int code{};
  std::string text;
};

// Also reads the files of --config and --token-file.  An address that other machines can reach requires a token and
// TLS, or the options that replace them; the error names the missing option.
[[nodiscard]] std::variant<Options, EarlyExit> parse_options(int argc, const char* const* argv);

}  // namespace selvage::server::app
