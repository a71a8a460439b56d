#include "clients/engine/open_markers.h"

#include <algorithm>
#include <utility>

namespace selvage::engine {

Current OpenMarker::current() const {
  const std::scoped_lock lock{mutex_};
  return now_;
}

State OpenMarker::peek(Origin origin) const {
  const std::scoped_lock lock{mutex_};
  const std::vector<State>& states = origin == Origin::kUndo ? undone_to_ : redone_to_;
  return states.empty() ? nullptr : states.back();
}

void OpenMarker::commit(State next, Origin origin) {
  const std::scoped_lock lock{mutex_};
  if (origin == Origin::kUndo) undone_to_.pop_back();
  if (origin == Origin::kRedo) redone_to_.pop_back();
  if (origin == Origin::kChange) redone_to_.clear();
  (origin == Origin::kUndo ? redone_to_ : undone_to_).push_back(std::exchange(now_.file, std::move(next)));
  if (undone_to_.size() > kMostUndone) undone_to_.erase(undone_to_.begin());
  ++now_.revision;
}

OpenMarkers::Opened OpenMarkers::open(MarkerFile file) {
  const std::scoped_lock lock{mutex_};
  const std::size_t number = ++opened_;
  Opened opened{"m" + std::to_string(number), std::make_shared<OpenMarker>(std::move(file))};
  return markers_.emplace(number, std::move(opened)).first->second;
}

std::shared_ptr<OpenMarker> OpenMarkers::find(const std::string& id) const {
  const std::scoped_lock lock{mutex_};
  const auto found = std::ranges::find(markers_, id, [](const auto& entry) { return entry.second.id; });
  return found == markers_.end() ? nullptr : found->second.marker;
}

bool OpenMarkers::close(const std::string& id) {
  const std::scoped_lock lock{mutex_};
  return std::erase_if(markers_, [&](const auto& entry) { return entry.second.id == id; }) > 0;
}

std::vector<OpenMarkers::Opened> OpenMarkers::all() const {
  const std::scoped_lock lock{mutex_};
  std::vector<Opened> markers;
  for (const auto& [number, opened] : markers_) markers.push_back(opened);
  return markers;
}

}  // namespace selvage::engine
