// What selvaged is told on its command line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "server/journal.h"
#include "server/limits.h"

namespace selvage {

struct Options {
  std::string host{"127.0.0.1"};  // a loopback address, in numbers
  std::uint16_t port{7171};       // 0: a free one
  std::string port_file;          // where to write the port that was taken; empty: nowhere
  std::size_t workers{};          // for motions; 0: inline, on the I/O thread (for tests)
  std::size_t cache_mb{256};      // for Minkowski sums
  std::string store;              // the journal's file; empty: markers live in memory only
  Durability durability{};
  std::string log_level{"info"};
  Limits limits;
};

// The command line asked for no server: --help, --version or a mistake.  `text` is for stdout when the code
// is 0, else for stderr.
struct Farewell {
  int exit_code{};
  std::string text;
};

[[nodiscard]] std::variant<Options, Farewell> parse_options(int argc, const char* const* argv);

}  // namespace selvage
