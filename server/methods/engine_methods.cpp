// The methods about the server itself: engine.info and rpc.discover.
#include "protocol/describe/openrpc.h"
#include "protocol/methods/daemon/engine.h"
#include "server/methods/handler_table.h"
#include "server/methods/method_groups.h"
#include "server/ops/version.h"

namespace selvage::server::methods {
namespace {

using protocol::methods::daemon::engine_info;
using protocol::methods::daemon::EngineInfo;
using protocol::methods::daemon::NoParams;

calls::Outcome info(const NoParams&, const ServerContext& server, const calls::OpenCall&) {
  EngineInfo info = engine_info(server.limits.transport.body_bytes);
  info.version = ops::kVersion;
  for (const HandlerTable::Row& row : server.methods.rows()) info.methods.push_back(row.method.name);
  info.workers = server.workers;
  info.markers = server.store.count();
  info.durable = server.store.is_durable();
  info.instance = server.store.identity();
  info.cache = protocol::calls::cache_counts_of(server.sums.counts());
  info.limits.markers_bytes = server.limits.markers_bytes;
  info.limits.marker_bytes = server.limits.marker_bytes;
  info.limits.waiting_motions = server.limits.waiting_motions;
  info.limits.waiting_reads = server.limits.waiting_reads;
  info.limits.waiting_moves = server.limits.waiting_moves;
  info.limits.call_ms = server.limits.call.count();
  info.limits.drags_per_connection = drags::DragSessions::kMaxPerConnection;
  info.limits.connections = server.limits.transport.connections;
  info.limits.calls_per_connection = server.limits.transport.calls_per_connection;
  return protocol::schema::encode(info);
}

calls::Outcome discover(const NoParams&, const ServerContext&, const calls::OpenCall&) {
  static const store::SharedText kText = std::make_shared<const std::string>(openrpc_text());
  return kText;
}

}  // namespace

std::string openrpc_text() {
  return protocol::json::to_text(protocol::describe::openrpc_document(ops::kVersion));
}

std::vector<HandledMethod> engine_methods() {
  return {{"engine.info", handle_with<NoParams, info>}, {"rpc.discover", handle_with<NoParams, discover>}};
}

}  // namespace selvage::server::methods
