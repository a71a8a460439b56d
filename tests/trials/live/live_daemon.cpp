#include "tests/trials/live/live_daemon.h"

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "tests/support/repository.h"

namespace selvage::trials {

LiveDaemon::LiveDaemon(const std::vector<std::string>& options) {
  // Nobody reads its log while it runs, so warnings go to a file and not into a pipe, which would fill up.
  std::vector<std::string> arguments{
      SELVAGED,        "--listen", "127.0.0.1:0",      "--listen-tcp",        "127.0.0.1:0",
      "--listen-unix", path(),     "--port-file",      folder_.file("ports"), "--log-level",
      "warn",          "--log",    folder_.file("log")};
  for (const std::string& option : options) arguments.push_back(option == "STORE" ? store() : option);
  process_.emplace(std::move(arguments));
  if (process_->output_until(path()).find(path()) == std::string::npos) {
    throw std::runtime_error{"selvaged does not listen"};
  }
  std::ifstream ports{folder_.file("ports")};
  ports >> port_ >> lines_port_;
}

Resources LiveDaemon::resources() const {
  const std::filesystem::path here = "/proc/" + std::to_string(process_->id());
  Resources found;
  std::ifstream status{here / "status"};
  for (std::string line; std::getline(status, line);) {
    std::istringstream arguments{line};
    std::string name;
    double kib{};
    arguments >> name >> kib;
    if (name == "VmRSS:") found.resident_mb = kib / 1024;
    if (name == "VmHWM:") found.peak_mb = kib / 1024;
  }
  for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator{here / "fd"}) ++found.descriptors;
  return found;
}

std::string LiveDaemon::log_text() const {
  std::ostringstream text;
  text << std::ifstream{folder_.file("log")}.rdbuf();
  return text.str();
}

void LiveDaemon::limit_address_space(std::size_t bytes) const {
  const rlimit limit{bytes, bytes};
  if (::prlimit(process_->id(), RLIMIT_AS, &limit, nullptr) != 0) throw std::runtime_error{"cannot limit selvaged"};
}

int LiveDaemon::end() {
  process_->signal(SIGTERM);
  return process_->exit_code();
}

std::string garment(const std::string& name) {
  return test::garment_text(name);
}

}  // namespace selvage::trials
