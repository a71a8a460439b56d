#include "core/nesting/local_search/neighbourhood.h"

#include <algorithm>
#include <cmath>

namespace selvage::nesting::local_search {
namespace {

constexpr float kDiagonal = 1.42F;  // of a unit square, rounded up

}  // namespace

void Neighbourhood::gather(const layout::Layout& layout, std::size_t piece, const layout::Place& place, double reach) {
  near_.clear();
  kept_reach_ = 0;
  const layout::Turned& own = set_->kind(piece).turned[place.turn];
  const RealBox box{own.box.low_x + place.x, own.box.low_y + place.y, own.box.high_x + place.x,
                    own.box.high_y + place.y};
  const double apart = reach + maps_->scale().pixel;
  boxes_.find_near(box, set_->widest + apart, candidates_);
  for (const std::uint32_t other : candidates_) {
    if (other == piece) continue;
    const layout::Place& at = layout.places[other];
    const layout::Turned& theirs = set_->kind(other).turned[at.turn];
    if (!may_meet(*set_, theirs, at, own, place, apart)) continue;
    const double x = place.x - at.x;
    const double y = place.y - at.y;
    const depth::MapView view = maps_->view(theirs, own);
    if (!view.within(static_cast<float>(x), static_cast<float>(y), static_cast<float>(reach))) continue;
    near_.push_back({.view = view,
                     .x = at.x,
                     .y = at.y,
                     .weight = losses_->weight(piece, other) * losses_->importance(piece, other)});
  }
}

void Neighbourhood::order_roughly(const layout::Place& place) {
  for (Near& near : near_) {
    const depth::MapFrame& frame = near.view.frame;
    const auto x = static_cast<float>(place.x - near.x);
    const auto y = static_cast<float>(place.y - near.y);
    near.there = near.weight * losses_->aimed(near.view.map->rough_depth(frame.map_x(x, y), frame.map_y(x, y)));
  }
  put_large_losses_first();
}

// Within the reach no position is farther from the place than the reach's diagonal.  So the nearest edge of any of them
// is among those whose distance from the place exceeds the least one by at most two diagonals.
void Neighbourhood::keep_edges(const layout::Place& place, double reach) {
  const auto diagonal = kDiagonal * static_cast<float>(reach);
  kept_reach_ = reach;
  std::size_t left = 0;
  for (const Near& found : near_) {
    Near near = found;
    const depth::DepthMap& map = *near.view.map;
    const auto x = static_cast<float>(place.x - near.x);
    const auto y = static_cast<float>(place.y - near.y);
    near.from_x = near.view.frame.map_x(x, y);
    near.from_y = near.view.frame.map_y(x, y);
    const depth::Nearness nearness = nearness_of_each(map.boundary(), near.from_x, near.from_y, squared_);
    near.from_inside = nearness.inside;
    const float distance = std::sqrt(nearness.squared_distance);
    if (!nearness.inside && distance - map.clearance() > diagonal) continue;
    const float limit = (distance + 2 * diagonal) * (distance + 2 * diagonal);
    if (left == kept_.size()) kept_.emplace_back();
    kept_[left].assign_near(map.boundary(), squared_, limit);
    near.kept = left;
    near.there = near.weight * losses_->aimed((nearness.inside ? distance : -distance) + map.clearance());
    near_[left++] = near;
  }
  near_.resize(left);
  put_large_losses_first();
}

void Neighbourhood::put_large_losses_first() {
  std::sort(near_.begin(), near_.end(), [](const Near& a, const Near& b) { return a.there > b.there; });
}

float Neighbourhood::depth(const Near& near, float x, float y) const {
  const depth::DepthMap& map = *near.view.map;
  const float map_x = near.view.frame.map_x(x, y);
  const float map_y = near.view.frame.map_y(x, y);
  const auto reach = static_cast<float>(kept_reach_);
  if (std::abs(map_x - near.from_x) > reach || std::abs(map_y - near.from_y) > reach) return map.depth(map_x, map_y);
  const depth::Nearness nearness =
      nearness_along(kept_[near.kept], near.from_x, near.from_y, near.from_inside, map_x, map_y);
  const float distance = std::sqrt(nearness.squared_distance);
  return std::max(0.0F, (nearness.inside ? distance : -distance) + map.clearance());
}

double Neighbourhood::loss(double x, double y, double bound) const {
  double total = 0;
  for (const Near& near : near_) {
    const auto to_x = static_cast<float>(x - near.x);
    const auto to_y = static_cast<float>(y - near.y);
    const float deep = kept_reach_ > 0 ? depth(near, to_x, to_y) : near.view.depth(to_x, to_y);
    total += near.weight * losses_->aimed(deep);
    if (total >= bound) break;
  }
  return total;
}

double Neighbourhood::rough_loss(double x, double y, double bound) const {
  double total = 0;
  for (const Near& near : near_) {
    const auto to_x = static_cast<float>(x - near.x);
    const auto to_y = static_cast<float>(y - near.y);
    const depth::MapFrame& frame = near.view.frame;
    const float deep = near.view.map->rough_depth(frame.map_x(to_x, to_y), frame.map_y(to_x, to_y));
    total += near.weight * losses_->aimed(deep);
    if (total >= bound) break;
  }
  return total;
}

}  // namespace selvage::nesting::local_search
