// The daemon that a command runs on instead of this process, as --server, --token-file and --trust name it.
#pragma once

#include <string>

namespace selvage::cli::run {

struct ServerChoice {
  bool asked{};  // false: the command runs in this process
  std::string address;
  std::string token_file;  // empty: the daemon needs no token
  std::string trusted;     // PEM file of certificates for TLS; empty: those of the system
  explicit operator bool() const { return asked; }
};

}  // namespace selvage::cli::run
