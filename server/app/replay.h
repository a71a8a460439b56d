// Answers the calls of a file one after another, without sockets.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/app/daemon.h"

namespace selvage::server::app {

// The answers in the order of the calls; a notification has none.
struct Replay {
  std::vector<std::string> answers;
  bool succeeded{true};  // true if no answer is an error
};

// `text`: one JSON-RPC call, or an array of calls, each of which is answered before the next one starts.
// Errors: those of protocol::json::parse.
[[nodiscard]] Result<Replay> replay(Daemon& daemon, const std::string& text);

// Draws the open marker; if several are open, the one that was opened last.  Errors: kFile if no marker is open.
[[nodiscard]] Result<std::string> draw_last_marker(Daemon& daemon);

}  // namespace selvage::server::app
