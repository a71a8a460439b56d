// The log, to stderr or a file: one line per call, and every failure.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace selvage::server::ops {

// `level`: debug, info, warn, error or off.  `file`: is appended to; empty: stderr.  Call it once, before any thread is
// started.  Throws a std::exception if the file cannot be opened.
void set_up_log(std::string_view level, const std::string& file);
// Reopens the file after the old one has been moved away.  Any thread.  If that fails, the old file is still used.
void reopen_log(const std::string& file);

struct AnsweredRequest {
  std::string method{};
  std::string marker{};  // its id; empty: none
  double milliseconds{};
  int code{};                           // of the JSON-RPC error; 0: no error
  std::size_t bytes_in{}, bytes_out{};  // of the message that contained it, and of its own answer
};
void log_request(const AnsweredRequest& request);
using OnAnswered = std::function<void(const AnsweredRequest&)>;

}  // namespace selvage::server::ops
