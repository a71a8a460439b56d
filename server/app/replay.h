// A session without sockets: the calls of a file, one after another, and their answers.
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "server/app/daemon.h"

namespace selvage::server::app {

// Answers in the order of the calls; a notification has none.
struct Replay {
  std::vector<std::string> answers;
  bool went_well{true};  // no answer is an error
};

// `text`: one JSON-RPC call, or an array of them, each answered before the next begins.
// Errors: those of parse.
[[nodiscard]] Result<Replay> replay(Daemon& daemon, const std::string& text);

// The drawing of the marker that is open; of the last that marker.list names, when there are several.
// Errors: kFile when no marker is open.
[[nodiscard]] Result<std::string> drawing_of_last(Daemon& daemon);

}  // namespace selvage::server::app
