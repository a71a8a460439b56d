// The daemon that commands run on instead of this process: `--server`, before or after a command's name.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace selvage::cli::run {

struct ServerChoice {
  std::string address;     // empty: this process
  std::string token_file;  // empty: the daemon wants no token
  std::string trusted;     // certificates, for TLS; empty: those of the system
  explicit operator bool() const { return !address.empty(); }
};

// --server, --token-file and --trust.  REQUIRES: called before commands are added.
void add_server_options(CLI::App& app);
// What the command line says.  REQUIRES: `command` is one of the app's, and the command line is parsed.
[[nodiscard]] ServerChoice server_choice(const CLI::App& command);

}  // namespace selvage::cli::run
