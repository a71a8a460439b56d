// The best marker that the searches of one nesting have found so far.  They may run on any threads.
#pragma once

#include <mutex>
#include <optional>
#include <utility>

#include "core/marker/marker.h"
#include "core/nesting/exploration.h"
#include "core/scene/run.h"

namespace selvage::nesting {

class BestOfAll {
 public:
  // Markers that are not shorter than `length` do not count.  REQUIRES: the observer outlives this.
  BestOfAll(const scene::Observer& observer, Coord length) : observer_{observer}, length_{length} {}

  // Reports the marker to the observer when it is better than all before.
  void offer(const Improvement& improvement, const Marker& marker) {
    const std::scoped_lock lock{mutex_};
    if (improvement.length >= length_) return;
    length_ = improvement.length;
    best_ = marker;
    observer_.on_round({.number = ++rounds_, .length = length_, .marker = &marker});
  }
  // Nothing when the best one is not shorter than this.
  [[nodiscard]] std::optional<Marker> shorter_than(Coord length) const {
    const std::scoped_lock lock{mutex_};
    return length_ < length ? best_ : std::nullopt;
  }

 private:
  const scene::Observer& observer_;
  mutable std::mutex mutex_;
  Coord length_;
  std::optional<Marker> best_;
  int rounds_{};
};

}  // namespace selvage::nesting
