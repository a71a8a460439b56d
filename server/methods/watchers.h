// Who watches which marker.  A watcher is told of every revision from the next one on, in order, until it stops
// watching, its connection ends or the marker is closed.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "server/transport/access/service.h"

namespace selvage::server::methods {

class Watchers {
 public:
  // REQUIRES: the session can be notified.
  void watch(const std::string& marker, const std::shared_ptr<transport::access::Session>& session);
  // False when it did not watch.
  bool unwatch(const std::string& marker, std::uint64_t session);
  // True when somebody is there to be told.
  [[nodiscard]] bool any(const std::string& marker) const;
  void tell(const std::string& marker, const std::string& message);
  // Tells a last time.
  void tell_and_forget(const std::string& marker, const std::string& message);

 private:
  using Sessions = std::map<std::uint64_t, std::weak_ptr<transport::access::Session>>;
  static void send(const Sessions& sessions, const std::string& message);

  mutable std::mutex mutex_;
  std::map<std::string, Sessions> watched_;
};

}  // namespace selvage::server::methods
