// selvaged: serves until it is told to stop (SIGTERM, SIGINT), then drains.
// Exit codes: 0 drained, 1 could not serve, 2 bad command line.
#include <spdlog/spdlog.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <variant>

#include "server/daemon.h"
#include "server/log.h"
#include "server/options.h"
#include "server/version.h"

namespace selvage {
namespace {

// Blocked in every thread, so that only wait_to_stop takes them.
sigset_t block_stop_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

int wait_for(const sigset_t& signals) {
  int signal{};
  while (sigwait(&signals, &signal) != 0) {
  }
  return signal;
}

// In one step, so that whoever waits for the file never reads half of it.
void write_port(const std::string& path, std::uint16_t port) {
  const std::string beside = path + ".new";
  std::ofstream file{beside};
  file << port << '\n';
  file.close();
  if (!file || std::rename(beside.c_str(), path.c_str()) != 0) {
    throw std::runtime_error{"cannot write --port-file " + path};
  }
}

void serve(const Options& options) {
  const sigset_t signals = block_stop_signals();
  Daemon daemon{options};
  const std::string host = options.host == "::1" ? "[::1]" : options.host;
  if (!options.port_file.empty()) write_port(options.port_file, daemon.port());
  std::cout << "listening on " << host << ":" << daemon.port() << std::endl;
  spdlog::info("selvaged {} listening on {}:{}, {} workers", kVersion, host, daemon.port(), options.workers);
  const int signal = wait_for(signals);
  spdlog::info("draining: signal {}", signal);
  daemon.drain();
  spdlog::info("drained");
}

}  // namespace
}  // namespace selvage

int main(int argc, char** argv) {
  const auto parsed = selvage::parse_options(argc, argv);
  if (const auto* farewell = std::get_if<selvage::Farewell>(&parsed)) {
    (farewell->exit_code == 0 ? std::cout : std::cerr) << farewell->text;
    return farewell->exit_code;
  }
  const auto& options = std::get<selvage::Options>(parsed);
  selvage::set_up_log(options.log_level);
  try {
    selvage::serve(options);
  } catch (const std::exception& error) {
    std::cerr << "selvaged: cannot serve on " << options.host << ":" << options.port << ": " << error.what() << "\n";
    return 1;
  }
  return 0;
}
