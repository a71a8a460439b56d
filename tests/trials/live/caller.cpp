#include "tests/trials/live/caller.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "tests/trials/live/error_codes.h"

namespace selvage::trials {

std::string call_text(const Json& id, const std::string& method, const Json& params) {
  return Json{{"jsonrpc", "2.0"}, {"id", id}, {"method", method}, {"params", params}}.dump();
}

int code_of(const Json& answer) {
  const auto error = answer.find("error");
  return error == answer.end() ? 0 : error->at("code").get<int>();
}

Caller::Caller(const LiveDaemon& daemon, Endpoint endpoint) {
  switch (endpoint) {
    case Endpoint::kShared: line_ = std::make_unique<test::Wire>(daemon.port()); break;
    case Endpoint::kTcp: line_ = std::make_unique<test::Wire>(daemon.lines_port()); break;
    case Endpoint::kUnix: line_ = std::make_unique<test::Wire>(daemon.path()); break;
    case Endpoint::kWebSocket: socket_ = std::make_unique<test::WebSocketWire>(daemon.port()); break;
  }
}

void Caller::send_text(std::string text) {
  if (socket_) return socket_->send_text(std::move(text));
  // Sends in parts, because the kernel may not interrupt a system call.  Sending megabytes in one call would keep a
  // processor from the daemon for milliseconds, which a client on another machine would not.
  constexpr std::size_t kPart = std::size_t{16} << 10;
  text += '\n';
  for (std::string_view left{text}; !left.empty(); left.remove_prefix(std::min(kPart, left.size()))) {
    line_->send(left.substr(0, kPart));
  }
}

std::optional<std::string> Caller::next_text() {
  return socket_ ? socket_->text() : line_->line();
}

int Caller::send(const std::string& method, const Json& params) {
  send_text(call_text(++last_id_, method, params));
  return last_id_;
}

void Caller::notify(const std::string& method, const Json& params) {
  send_text(Json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump());
}

Json Caller::next_answer() {
  for (;;) {
    const auto text = next_text();
    if (!text) throw std::runtime_error{"the connection has ended"};
    Json message = Json::parse(*text);
    if (message.contains("id")) return message;
    ++notifications_;
  }
}

Json Caller::ask(const std::string& method, const Json& params) {
  const int id = send(method, params);
  Json answer = next_answer();
  // A call that is dropped before it has been read, because there is no room for it, is answered with no id.
  const bool dropped = answer["id"].is_null() && code_of(answer) == kNoRoom;
  if (answer["id"] != id && !dropped) throw std::runtime_error{method + " is answered by " + answer.dump()};
  return answer;
}

Json Caller::result(const std::string& method, const Json& params) {
  Json answer = ask(method, params);
  if (code_of(answer) != 0) throw std::runtime_error{method + ": " + answer.dump()};
  return std::move(answer["result"]);
}

}  // namespace selvage::trials
