// Which sessions watch which marker.
//
// A watching session is notified of every revision from the next one on, in order, and of the pieces that others drag,
// until it stops watching, its connection ends or the marker is closed.  Every function may be called from any thread.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/transport/access/service.h"

namespace selvage::server::changes {

class Watchers {
 public:
  // REQUIRES: the session can be notified.
  void watch(const std::string& marker, const std::shared_ptr<transport::access::Session>& session);
  // Returns false if the session did not watch the marker.
  bool unwatch(const std::string& marker, std::uint64_t session);
  // Returns true if at least one session watches the marker.
  [[nodiscard]] bool any(const std::string& marker) const;
  void notify(const std::string& marker, const std::string& message);
  // Sends each watching session, except one, its own message.
  void notify_others(const std::string& marker, std::uint64_t except,
                     const std::function<std::string(std::uint64_t session)>& message);
  // Sends the last notification about a marker and removes its watchers.
  void notify_and_remove(const std::string& marker, const std::string& message);

 private:
  using Sessions = std::map<std::uint64_t, std::weak_ptr<transport::access::Session>>;
  static void send(const Sessions& sessions, const std::string& message);
  // The sessions that watch the marker and are still connected.
  [[nodiscard]] Sessions watching(const std::string& marker);

  mutable std::mutex mutex_;
  std::map<std::string, Sessions> watched_;
};

}  // namespace selvage::server::changes
