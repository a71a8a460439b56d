// A selvaged that a trial starts with listeners of every kind, and the resources that it uses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tests/end_to_end/process.h"
#include "tests/server/store/temporary_folder.h"

namespace selvage::trials {

struct Resources {
  double resident_mb{}, peak_mb{};  // MiB
  std::size_t descriptors{};        // open files and sockets
};

class LiveDaemon {
 public:
  // Throws if it does not listen.
  explicit LiveDaemon(const std::vector<std::string>& options = {});

  [[nodiscard]] std::uint16_t port() const { return port_; }              // HTTP, WebSocket, lines
  [[nodiscard]] std::uint16_t lines_port() const { return lines_port_; }  // lines only
  [[nodiscard]] std::string path() const { return folder_.file("socket"); }
  [[nodiscard]] std::string store() const { return folder_.file("store"); }  // a path for a store
  [[nodiscard]] pid_t process_id() const { return process_->id(); }
  [[nodiscard]] Resources resources() const;
  [[nodiscard]] std::string log_text() const;

  // Limits its address space to this many bytes from now on.
  void limit_address_space(std::size_t bytes) const;
  // Asks it to shut down and returns its exit code.
  int end();

 private:
  test::TemporaryFolder folder_;
  std::optional<test::Process> process_;
  std::uint16_t port_{}, lines_port_{};
};

// The native document of an example marker.
[[nodiscard]] std::string garment(const std::string& name);

}  // namespace selvage::trials
