// What is logged, to stderr: one line per request, and what goes wrong.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace selvage {

// `level`: debug, info, warn, error or off.  Call once, before any thread.
void set_up_log(std::string_view level);

struct AnsweredRequest {
  std::string method{};
  std::string marker{};  // its id; empty: none
  double milliseconds{};
  int code{};                           // of the JSON-RPC error; 0: it went well
  std::size_t bytes_in{}, bytes_out{};  // of the message it came in, and of its own answer
};
void log_request(const AnsweredRequest& request);

}  // namespace selvage
