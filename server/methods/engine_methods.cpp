// The methods about the server itself: engine.info and rpc.discover.
#include <utility>

#include "protocol/calls/codec.h"
#include "protocol/describe/daemon_methods.h"
#include "protocol/describe/openrpc.h"
#include "protocol/methods/marker_methods.h"
#include "server/methods/method_groups.h"
#include "server/methods/method_table.h"
#include "server/ops/version.h"

namespace selvage::server::methods {
namespace {

calls::Outcome info(const protocol::calls::NoParams&, const ServerContext& server, const calls::OpenCall&) {
  protocol::calls::EngineInfo info;
  info.version = ops::kVersion;
  info.workers = static_cast<int>(server.workers);
  info.markers = server.store.count();
  info.max_request_bytes = server.limits.transport.body_bytes;
  info.cache = server.sums.counts();
  for (const Method& method : server.methods.methods()) info.methods.push_back(method.name);
  Json result = protocol::calls::encode(info);
  result["limits"].update(Json{{"openMarkers", server.limits.open_markers},
                               {"waitingMotions", server.limits.waiting_motions},
                               {"waitingReads", server.limits.waiting_reads},
                               {"waitingMoves", server.limits.waiting_moves},
                               {"callMs", server.limits.call.count()},
                               {"dragsPerConnection", drags::DragSessions::kMaxPerConnection},
                               {"connections", server.limits.transport.connections},
                               {"callsPerConnection", server.limits.transport.calls_per_connection}});
  return result;
}

calls::Outcome discover(const protocol::calls::NoParams&, const ServerContext&, const calls::OpenCall&) {
  static const store::SharedText kText = std::make_shared<const std::string>(openrpc_text());
  return kText;
}

}  // namespace

std::string openrpc_text() {
  std::vector<protocol::describe::ToldMethod> methods;
  for (const protocol::describe::NamedWords& own : protocol::describe::daemon_words())
    methods.push_back(protocol::describe::told(own.name, own.words));
  for (const protocol::calls::MarkerMethod& method : protocol::methods::marker_methods())
    methods.push_back(protocol::describe::told(method));
  return protocol::json::to_text(openrpc_document(ops::kVersion, methods));
}

std::vector<Method> engine_methods() {
  using protocol::calls::decode_no_params;
  return {{"engine.info", Schedule::kInline, decode_and_run<decode_no_params, info>},
          {"rpc.discover", Schedule::kInline, decode_and_run<decode_no_params, discover>}};
}

}  // namespace selvage::server::methods
