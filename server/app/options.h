// What selvaged is told on its command line, or by a file of the same words.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "server/calls/limits.h"
#include "server/store/journal.h"
#include "server/transport/access/listener.h"

namespace selvage::server::app {

struct Options {
  // What it is to do.
  enum class Task {
    kServe,
    kCheckConfig,  // say whether it could serve like this
    kReplay,       // answer the calls of a file, without sockets
  };
  Task task{};
  std::string replay_file, replay_svg;

  std::string host{"127.0.0.1"};                       // where HTTP is spoken; an address in numbers
  std::uint16_t port{7171};                            // 0: a free one
  std::vector<transport::access::Listener> listeners;  // others
  transport::access::Access access;
  std::optional<transport::access::TlsFiles> tls;
  std::string port_file;      // where to write the ports that were taken, a line each; empty: nowhere
  std::size_t workers{};      // for motions; 0: inline, on the I/O thread (for tests)
  std::size_t cache_mb{256};  // for Minkowski sums
  std::string store;          // the journal's file; empty: markers live in memory only
  store::Durability durability{};
  std::string log_level{"info"};
  std::string log_file;            // empty: stderr
  std::chrono::seconds drain{10};  // from the signal to the end, at most
  calls::Limits limits;
};

// Every TCP port and Unix socket of these options, HTTP first.
[[nodiscard]] transport::access::Doors doors_of(const Options& options);

// The command line asked for no daemon: --help, --version or a mistake.  `text` is for stdout when the code
// is 0, else for stderr.
struct Farewell {
  int exit_code{};
  std::string text;
};

// Reads the files of --config and --token-file.  An address that other machines reach is refused without a token and
// TLS, or what stands for them; the text names the option that is missing.
[[nodiscard]] std::variant<Options, Farewell> parse_options(int argc, const char* const* argv);

}  // namespace selvage::server::app
