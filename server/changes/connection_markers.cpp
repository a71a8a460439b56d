#include "server/changes/connection_markers.h"

#include <utility>

#include "protocol/json/json_text.h"
#include "protocol/methods/daemon/markers.h"
#include "protocol/rpc/json_rpc.h"

namespace selvage::server::changes {

store::Closed close_marker(store::MarkerStore& store, Watchers& watchers, const std::string& id,
                           const std::optional<store::KeptAnswer>& answer) {
  return store.close(id, answer, [&] {
    const Json params = protocol::schema::encode(protocol::methods::daemon::MarkerIdParams{id});
    watchers.notify_and_remove(id, protocol::json::to_text(protocol::rpc::notification("marker.closed", params)));
  });
}

void ConnectionMarkers::add(const std::string& marker, const transport::access::Session& session) {
  const auto on_gone = std::make_shared<OnGone>();
  {
    const std::lock_guard lock{mutex_};
    markers_.insert_or_assign(marker, on_gone);
  }
  on_gone->emplace(session.gone, [this, marker, id = session.id] { abandon(marker, id); });
}

void ConnectionMarkers::remove(const std::string& marker) {
  (void)extract(marker);
}

std::shared_ptr<ConnectionMarkers::OnGone> ConnectionMarkers::extract(const std::string& marker) {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(marker);
  if (found == markers_.end()) return nullptr;
  const auto on_gone = std::move(found->second);
  markers_.erase(found);
  return on_gone;
}

void ConnectionMarkers::abandon(const std::string& marker, std::uint64_t session) {
  const auto on_gone = extract(marker);  // held until the end, because the callback that runs now owns `marker`
  if (!on_gone) return;
  // A journal that cannot be written keeps the marker until the next start, which closes it.
  const auto close = [this, marker](auto&&) { (void)close_marker(store_, watchers_, marker); };
  jobs::Job job{.session = session, .lane = {}, .caller = {}, .work = jobs::Work{close}};
  if (queue_.submit(job) != jobs::Admission::kAccepted) close(std::stop_token{});
}

}  // namespace selvage::server::changes
