// What is logged, to stderr or a file: one line per request, and what goes wrong.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace selvage::server::ops {

// `level`: debug, info, warn, error or off.  `file`: appended to; empty: stderr.  Call once, before any thread.
// Throws a std::exception when the file cannot be opened.
void set_up_log(std::string_view level, const std::string& file);
// Opens the file anew: the old one has been moved away.  Any thread.  When that fails, logging goes on into the old
// one.
void reopen_log(const std::string& file);

struct AnsweredRequest {
  std::string method{};
  std::string marker{};  // its id; empty: none
  double milliseconds{};
  int code{};                           // of the JSON-RPC error; 0: it went well
  std::size_t bytes_in{}, bytes_out{};  // of the message it came in, and of its own answer
};
void log_request(const AnsweredRequest& request);
using OnAnswered = std::function<void(const AnsweredRequest&)>;

}  // namespace selvage::server::ops
