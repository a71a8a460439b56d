// The methods of the server, one group per source file.
#pragma once

#include <functional>
#include <vector>

#include "protocol/calls/method.h"
#include "server/methods/parsed_call.h"

namespace selvage::server::methods {

[[nodiscard]] std::vector<Method> engine_methods();  // engine.info, rpc.discover
[[nodiscard]] std::vector<Method> marker_methods();  // marker.open, .list, .get, .close
[[nodiscard]] std::vector<Method> watch_methods();   // marker.watch, .unwatch
[[nodiscard]] std::vector<Method> change_methods();  // marker.apply, .undo, .redo
[[nodiscard]] std::vector<Method> drag_methods();    // drag.begin, .move, .end
[[nodiscard]] std::vector<Method> motion_methods();  // those of protocol/methods, which the command line runs, too

// A method that works on one marker.  `read` takes the place of the method's own decoder and of what it runs: this is
// where tests put their own functions.
using ReadMarkerCall = std::function<Result<protocol::calls::MarkerCall>(const Json& params)>;
[[nodiscard]] Method method_on_marker(const protocol::calls::MarkerMethod& method);
[[nodiscard]] Method method_on_marker(const protocol::calls::MarkerMethod& method, ReadMarkerCall read);

// The OpenRPC document of all methods, as text.
[[nodiscard]] std::string openrpc_text();

}  // namespace selvage::server::methods
