#include "server/changes/watchers.h"

#include <utility>

namespace selvage::server::changes {
namespace {

bool is_connected(const std::shared_ptr<transport::access::Session>& session) {
  return session && !session->gone.stop_requested();
}

}  // namespace

void Watchers::watch(const std::string& marker, const std::shared_ptr<transport::access::Session>& session) {
  const std::lock_guard lock{mutex_};
  Sessions& sessions = watched_[marker];
  std::erase_if(sessions, [](const auto& entry) { return !is_connected(entry.second.lock()); });
  sessions.insert_or_assign(session->id, session);
}

bool Watchers::unwatch(const std::string& marker, std::uint64_t session) {
  const std::lock_guard lock{mutex_};
  const auto found = watched_.find(marker);
  if (found == watched_.end()) return false;
  const bool watched = found->second.erase(session) > 0;
  if (found->second.empty()) watched_.erase(found);
  return watched;
}

bool Watchers::any(const std::string& marker) const {
  const std::lock_guard lock{mutex_};
  return watched_.contains(marker);
}

Watchers::Sessions Watchers::watching(const std::string& marker) {
  const std::lock_guard lock{mutex_};
  const auto found = watched_.find(marker);
  if (found == watched_.end()) return {};
  std::erase_if(found->second, [](const auto& entry) { return !is_connected(entry.second.lock()); });
  Sessions sessions = found->second;
  if (sessions.empty()) watched_.erase(found);
  return sessions;
}

void Watchers::notify(const std::string& marker, const std::string& message) {
  send(watching(marker), message);
}

void Watchers::notify_others(const std::string& marker, std::uint64_t except,
                             const std::function<std::string(std::uint64_t session)>& message) {
  for (const auto& [id, weak] : watching(marker)) {
    const auto session = weak.lock();
    if (id != except && is_connected(session)) session->notify(message(id));
  }
}

void Watchers::notify_and_remove(const std::string& marker, const std::string& message) {
  Sessions sessions;
  {
    const std::lock_guard lock{mutex_};
    const auto found = watched_.find(marker);
    if (found == watched_.end()) return;
    sessions = std::move(found->second);
    watched_.erase(found);
  }
  send(sessions, message);
}

void Watchers::send(const Sessions& sessions, const std::string& message) {
  for (const auto& [id, weak] : sessions) {
    const auto session = weak.lock();
    if (is_connected(session)) session->notify(message);
  }
}

}  // namespace selvage::server::changes
