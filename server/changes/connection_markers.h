// Markers that belong to the connection that opened them (closeWithConnection of marker.open): each is closed when its
// connection ends, unless it was closed before.  Every function may be called from any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>

#include "server/changes/watchers.h"
#include "server/jobs/job_queue.h"
#include "server/store/marker_store.h"

namespace selvage::server::changes {

// Closes a marker and notifies those who watch it.
[[nodiscard]] store::Closed close_marker(store::MarkerStore& store, Watchers& watchers, const std::string& id,
                                         const std::optional<store::KeptAnswer>& answer = {});

class ConnectionMarkers {
 public:
  // Markers are closed on the workers of `queue`, because closing may wait for the disk.  REQUIRES: the references
  // outlive this object, and the queue has drained before its end.
  ConnectionMarkers(store::MarkerStore& store, Watchers& watchers, jobs::JobQueue& queue)
      : store_{store}, watchers_{watchers}, queue_{queue} {}

  // If the connection has ended already, the marker is closed at once.
  void add(const std::string& marker, const transport::access::Session& session);
  // The marker has been closed.
  void remove(const std::string& marker);

 private:
  // Destroyed while the mutex is not held, because the callback may be waiting for it.
  using OnGone = std::optional<std::stop_callback<std::function<void()>>>;

  void abandon(const std::string& marker, std::uint64_t session);
  // Null if the marker belongs to no connection.
  [[nodiscard]] std::shared_ptr<OnGone> extract(const std::string& marker);

  store::MarkerStore& store_;
  Watchers& watchers_;
  jobs::JobQueue& queue_;
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<OnGone>> markers_;
};

}  // namespace selvage::server::changes
