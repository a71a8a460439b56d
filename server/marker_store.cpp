#include "server/marker_store.h"

#include <utility>

namespace selvage {

std::optional<OpenMarker> MarkerStore::open(MarkerFile file) {
  Committed first{1, std::make_shared<const MarkerFile>(std::move(file))};
  const std::lock_guard lock{mutex_};
  if (markers_.size() >= limit_) return std::nullopt;
  std::string id = "m" + std::to_string(++opened_);
  markers_.emplace(id, first);
  return OpenMarker{std::move(id), std::move(first)};
}

std::optional<Committed> MarkerStore::current(const std::string& id) const {
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  if (found == markers_.end()) return std::nullopt;
  return found->second;
}

Commit MarkerStore::commit(const std::string& id, Revision base, MarkerFile file) {
  auto next = std::make_shared<const MarkerFile>(std::move(file));
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  if (found == markers_.end()) return {Commit::Outcome::kClosed, 0};
  Committed& held = found->second;
  if (held.revision != base) return {Commit::Outcome::kMismatch, held.revision};
  // Swapped, not assigned: the old marker may be large, and is freed once the mutex is released.
  std::swap(held.file, next);
  return {Commit::Outcome::kDone, ++held.revision};
}

bool MarkerStore::close(const std::string& id) {
  Committed last;  // freed once the mutex is released
  const std::lock_guard lock{mutex_};
  const auto found = markers_.find(id);
  if (found == markers_.end()) return false;
  last = std::move(found->second);
  markers_.erase(found);
  return true;
}

std::size_t MarkerStore::count() const {
  const std::lock_guard lock{mutex_};
  return markers_.size();
}

}  // namespace selvage
