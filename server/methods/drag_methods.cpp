// The methods of a drag session: drag.begin, drag.move and drag.end.  Moves and ends wait in a queue of their own
// (server/drags), so that these calls are scheduled inline.
#include "protocol/methods/readings/drag_messages.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

namespace readings = protocol::methods::readings;

calls::Outcome begin(const readings::DragBegin& request, const ServerContext& server, const calls::OpenCall& call) {
  return server.drags.begin(request, call.session());
}

// The `decode` of a method whose call the drag sessions answer.
template <auto decode_params, auto run>
Result<ParsedCall> decode_for_session(const Json& params, const ServerContext& server) {
  auto decoded = decode_params(params);
  if (!decoded) return decoded.error();
  ParsedCall call;
  copy_common_fields(*decoded, call);
  call.run = [request = *std::move(decoded), &server](const std::shared_ptr<calls::OpenCall>& open) {
    (server.drags.*run)(request, open);
  };
  return call;
}

}  // namespace

std::vector<Method> drag_methods() {
  using drags::DragSessions;
  return {{"drag.begin", Schedule::kInline, decode_and_run<readings::decode_drag_begin, begin>},
          {"drag.move", Schedule::kInline, decode_for_session<readings::decode_drag_move, &DragSessions::move>},
          {"drag.end", Schedule::kInline, decode_for_session<readings::decode_drag_end, &DragSessions::end>}};
}

}  // namespace selvage::server::methods
