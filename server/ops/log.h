// The log, to stderr or a file: one line per call, every failure, and refusals at a limited rate.
//
// A line of text begins with the time in UTC and the level.  As JSON, each line is an object with `time`, `level` and
// `message`; that of a call also has `method`, `marker`, `ms`, `code`, `peer`, `session`, `request`, `bytesIn` and
// `bytesOut`, that of a refusal `peer`, `reason` and `withheld`.  No caller waits for the file (log_writer.h).
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace selvage::server::ops {

enum class LogFormat { kText, kJson };

struct LogSettings {
  std::string level{"info"};  // debug, info, warn, error or off
  std::string file{};         // is appended to; empty: stderr
  LogFormat format{};
};

// Call it once, before any thread is started.  Throws a std::exception if the file cannot be opened.
void set_up_log(const LogSettings& settings);
// Reopens the file after the old one has been moved away.  Any thread.  If that fails, the old file is still used.
void reopen_log(const std::string& file);
// Waits until all lines have been written, for at most `time`.  Call it before the process ends.
void flush_log(std::chrono::milliseconds time);
// How many lines have been dropped since the start, because they could not be written, or not quickly enough.
[[nodiscard]] std::uint64_t dropped_log_lines();

struct AnsweredRequest {
  std::string method{};
  std::string marker{};  // its id; empty: none
  double milliseconds{};
  int code{};                           // of the JSON-RPC error; 0: no error
  std::size_t bytes_in{}, bytes_out{};  // of the message that contained it, and of its own answer
  std::string peer{};                   // the address of the client; empty: it came over no connection
  std::uint64_t session{};
  std::string request{};  // its id as JSON; empty: a notification
};
void log_request(const AnsweredRequest& request);
using OnAnswered = std::function<void(const AnsweredRequest&)>;

struct RefusedCaller {
  std::string_view reason{};  // a word
  std::string peer{};
  std::uint64_t withheld{};  // how many lines with the same reason were not logged since the last one
};
void log_refusal(const RefusedCaller& refused);

}  // namespace selvage::server::ops
