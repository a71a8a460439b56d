// The handlers of the methods, one group per source file.
#pragma once

#include <string>
#include <vector>

#include "protocol/calls/method.h"
#include "server/methods/handler.h"

namespace selvage::server::methods {

[[nodiscard]] std::vector<HandledMethod> engine_methods();   // engine.info, rpc.discover
[[nodiscard]] std::vector<HandledMethod> marker_methods();   // marker.open, .list, .get, .close
[[nodiscard]] std::vector<HandledMethod> watch_methods();    // marker.watch, .unwatch
[[nodiscard]] std::vector<HandledMethod> change_methods();   // marker.apply, .undo, .redo
[[nodiscard]] std::vector<HandledMethod> drag_methods();     // drag.begin, .move, .end
[[nodiscard]] std::vector<HandledMethod> admin_methods();    // admin.backup
[[nodiscard]] std::vector<HandledMethod> library_methods();  // library.add, .get, .list, .remove, .search

// The handler of a method on one marker, which the command line also runs.  REQUIRES: method.on_marker.
[[nodiscard]] Handler motion_handler(const protocol::calls::Method& method);

// The OpenRPC document of all methods, as text.
[[nodiscard]] std::string openrpc_text();

}  // namespace selvage::server::methods
