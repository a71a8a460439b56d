// The methods of a drag session: drag.begin, drag.move and drag.end.  The session answers moves and ends when their
// turn comes in its own queue (server/drags).
#include "protocol/methods/dragging/drag_messages.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::methods::dragging::BeginParams;
using protocol::methods::dragging::EndParams;
using protocol::methods::dragging::MoveParams;

calls::Outcome begin(const BeginParams& params, const ServerContext& server, const calls::OpenCall& call) {
  return server.drags.begin(params, call.session());
}

void move(const protocol::calls::ParsedCall& parsed, const ServerContext& server,
          const std::shared_ptr<calls::OpenCall>& call) {
  server.drags.move(parsed.params_as<MoveParams>(), call);
}

void end(const protocol::calls::ParsedCall& parsed, const ServerContext& server,
         const std::shared_ptr<calls::OpenCall>& call) {
  server.drags.end(parsed.params_as<EndParams>(), call);
}

}  // namespace

std::vector<HandledMethod> drag_methods() {
  return {{"drag.begin", handle_with<BeginParams, begin>}, {"drag.move", move}, {"drag.end", end}};
}

}  // namespace selvage::server::methods
