// The methods that start and stop change notifications: marker.watch and marker.unwatch.
#include <string>

#include "protocol/calls/codec.h"
#include "server/calls/errors.h"
#include "server/methods/method_groups.h"

namespace selvage::server::methods {
namespace {

calls::Outcome watch(const std::string& id, const ServerContext& server, const calls::OpenCall& call) {
  const auto& session = call.session();
  if (!session->notify) return calls::no_notifications();
  if (!server.store.current(id)) return calls::unknown_marker(id);
  // The session watches before the revision is read, so that it misses none in between.
  server.watchers.watch(id, session);
  const auto now = server.store.current(id);
  if (!now) {
    (void)server.watchers.unwatch(id, session->id);
    return calls::unknown_marker(id);
  }
  return Json{{"markerId", id}, {"revision", now->revision}, {"watching", true}};
}

calls::Outcome unwatch(const std::string& id, const ServerContext& server, const calls::OpenCall& call) {
  const bool watched = server.watchers.unwatch(id, call.session()->id);
  return Json{{"markerId", id}, {"watching", false}, {"watched", watched}};
}

}  // namespace

std::vector<Method> watch_methods() {
  using protocol::calls::decode_marker_id;
  return {{"marker.watch", Schedule::kInline, decode_and_run<decode_marker_id, watch>},
          {"marker.unwatch", Schedule::kInline, decode_and_run<decode_marker_id, unwatch>}};
}

}  // namespace selvage::server::methods
