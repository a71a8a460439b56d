// The methods that start and stop change notifications: marker.watch and marker.unwatch.
#include "protocol/methods/daemon/markers.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

using protocol::methods::daemon::MarkerIdParams;
using protocol::methods::daemon::UnwatchResult;
using protocol::methods::daemon::WatchResult;

calls::Outcome watch(const MarkerIdParams& params, const ServerContext& server, const calls::OpenCall& call) {
  const std::string& id = params.marker_id;
  const auto& session = call.session();
  if (!session->notify) return calls::no_notifications();
  if (!server.store.current(id)) return calls::unknown_marker(server.store, id);
  // The session starts watching before the revision is read, so that it misses none in between.
  server.watchers.watch(id, session);
  const auto now = server.store.current(id);
  if (!now) {
    (void)server.watchers.unwatch(id, session->id);
    return calls::unknown_marker(server.store, id);
  }
  server.drags.notify(id, *session);
  return protocol::schema::encode(WatchResult{{id, now->revision}});
}

calls::Outcome unwatch(const MarkerIdParams& params, const ServerContext& server, const calls::OpenCall& call) {
  const bool watched = server.watchers.unwatch(params.marker_id, call.session()->id);
  return protocol::schema::encode(UnwatchResult{params.marker_id, false, watched});
}

}  // namespace

std::vector<HandledMethod> watch_methods() {
  return {{"marker.watch", handle_with<MarkerIdParams, watch>},
          {"marker.unwatch", handle_with<MarkerIdParams, unwatch>}};
}

}  // namespace selvage::server::methods
