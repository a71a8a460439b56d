// Writes the lines of the log on a thread of its own, so that no other thread ever waits for a file, for a terminal, or
// for a pipe that nobody reads.
//
// Lines wait in a queue of bounded size.  When it is full, further lines are dropped and counted; as soon as the log
// can be written again, it receives a line that says how many are missing.  Lines that cannot be written, for example
// because the disk is full, are dropped as well.  Every function may be called from any thread.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace selvage::server::ops {

// A file descriptor that is closed with its last owner.
class OpenFile {
 public:
  explicit OpenFile(int descriptor) : descriptor_{descriptor} {}
  ~OpenFile();
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  int descriptor_;
};

class LogWriter {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{4} << 20;  // in the queue; as many again are being written

  // `missing` returns the line, without its end, that reports how many lines are missing.
  LogWriter(std::shared_ptr<const OpenFile> file, std::function<std::string(std::uint64_t)> missing,
            std::size_t most_bytes = kMostBytes);
  // The lines in the queue are still written if possible.  The destructor does not wait for the thread, because that
  // may never return from its last write.
  ~LogWriter();
  LogWriter(const LogWriter&) = delete;
  LogWriter& operator=(const LogWriter&) = delete;

  // `line` without its end.
  void add(std::string_view line);
  // Writes the lines that are still in the queue, and all later ones, to this file.
  void change_file(std::shared_ptr<const OpenFile> file);
  // Waits until all lines have been written, for at most `time`.  Returns false if they have not.
  bool flush(std::chrono::milliseconds time);
  // Since the beginning.
  [[nodiscard]] std::uint64_t dropped() const;

 private:
  struct State;
  const std::shared_ptr<State> state_;  // shared with the thread
};

}  // namespace selvage::server::ops
