// A selvaged process that listens on a Unix socket and a free port.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "clients/cpp/client.h"
#include "tests/end_to_end/process.h"
#include "tests/support/repository.h"

namespace selvage::test {

using client::Answer;
using client::Call;
using client::CallCode;
using client::CallError;
using client::Client;
using client::Handlers;
using client::Json;
using client::Settings;

inline std::string text_of_file(const std::string& path) {
  std::ifstream file{path};
  return {std::istreambuf_iterator<char>{file}, {}};
}
inline std::string path_of_marker(const std::string& name) {
  return repository_path("examples/markers/" + name + ".json");
}
inline Json garment(const std::string& name) {
  return Json::parse(garment_text(name));
}

class LiveDaemon {
 public:
  explicit LiveDaemon(std::vector<std::string> options = {}) : options_{std::move(options)} {
    std::string name = (std::filesystem::temp_directory_path() / "selvage-client-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    start();
  }
  ~LiveDaemon() {
    process_.reset();
    std::filesystem::remove_all(folder_);
  }
  LiveDaemon(const LiveDaemon&) = delete;
  LiveDaemon& operator=(const LiveDaemon&) = delete;

  void start() {
    std::vector<std::string> arguments{SELVAGED,     "--listen",      "127.0.0.1:0", "--port-file",
                                       path("port"), "--listen-unix", path("socket")};
    arguments.insert(arguments.end(), options_.begin(), options_.end());
    process_ = std::make_unique<Process>(std::move(arguments));
    (void)process_->output_until(path("socket") + "\n");
  }
  void kill() {
    process_->signal(SIGKILL);
    (void)process_->exit_code();
  }
  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }
  [[nodiscard]] std::string socket() const { return path("socket"); }
  [[nodiscard]] std::string tcp() const { return "127.0.0.1:" + std::to_string(std::stoi(text_of_file(path("port")))); }

 private:
  std::vector<std::string> options_;
  std::filesystem::path folder_;
  std::unique_ptr<Process> process_;
};

}  // namespace selvage::test
