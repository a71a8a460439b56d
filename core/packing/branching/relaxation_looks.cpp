// Looks at rings: which cells of an arc a pair can still reach, and what that says of its box.
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/packing/branching/relaxation.h"

namespace selvage::packing::branching {
namespace {

bool apart(const RealBox& a, const RealBox& b) {
  return a.high_x <= b.low_x || b.high_x <= a.low_x || a.high_y <= b.low_y || b.high_y <= a.low_y;
}
// Whether all corners of the box are free positions: then the hull of the free ones in the box is the box.
bool has_free_corners(const RealBox& box, const WedgeRing& wedges) {
  return wedges.is_free({box.low_x, box.low_y}) && wedges.is_free({box.high_x, box.low_y}) &&
         wedges.is_free({box.low_x, box.high_y}) && wedges.is_free({box.high_x, box.high_y});
}
bool is_all_of(const RealBox& part, const RealBox& box) {
  return part.low_x <= box.low_x && part.low_y <= box.low_y && part.high_x >= box.high_x && part.high_y >= box.high_y;
}
// The box of the lattice points in it.
RealBox whole_within(const RealBox& box) {
  return {std::ceil(box.low_x - cells::kRounding), std::ceil(box.low_y - cells::kRounding),
          std::floor(box.high_x + cells::kRounding), std::floor(box.high_y + cells::kRounding)};
}
// Whether `now` is much smaller than `before`.
bool shrank(const RealBox& before, const RealBox& now, double part) {
  const double least = part * std::max({before.width(), before.height(), 1.0});
  return now.low_x > before.low_x + least || now.high_x < before.high_x - least || now.low_y > before.low_y + least ||
         now.high_y < before.high_y - least;
}

}  // namespace

RealBox Relaxation::pair_box(const Node& node, const RingState& ring) const {
  return {node.x.lower(ring.first, ring.second), node.y.lower(ring.first, ring.second),
          node.x.upper(ring.first, ring.second), node.y.upper(ring.first, ring.second)};
}

Reasons Relaxation::why_pair_box(const Node& node, const RingState& ring) {
  return node.x.why_lower(ring.first, ring.second) | node.y.why_lower(ring.first, ring.second) |
         node.x.why_upper(ring.first, ring.second) | node.y.why_upper(ring.first, ring.second);
}

bool Relaxation::raise_to(Node& node, const RingState& ring, const RealBox& box, Reasons why) {
  return raise(node.x, ring.first, ring.second, box.low_x, why) &&
         raise(node.x, ring.second, ring.first, -box.high_x, why) &&
         raise(node.y, ring.first, ring.second, box.low_y, why) &&
         raise(node.y, ring.second, ring.first, -box.high_y, why);
}

// The box of the arc's cells within `box`; nothing when they are all empty.  Empty cells at the ends are cut off, but
// for a whole ring, which has no ends.
std::optional<RealBox> Relaxation::trim(const WedgeRing& wedges, Arc& arc, const RealBox& box) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  RealBox found{kFar, kFar, -kFar, -kFar};
  Cell cell;
  const auto include = [&found](double x, double y) {
    found = {std::min(found.low_x, x), std::min(found.low_y, y), std::max(found.high_x, x), std::max(found.high_y, y)};
  };
  const auto is_empty = [&](std::uint32_t k) {
    if (!wedges.clip((arc.first + k) % wedges.size(), box, cell)) return true;
    for (std::size_t c = 0; c < cell.count; ++c) include(cell.x[c], cell.y[c]);
    return false;
  };
  const WedgeRing::Part part = wedges.part_facing(arc, box);
  std::uint32_t first = part.begin, end = part.end;
  while (first < end && is_empty(first)) ++first;
  if (first >= end) return std::nullopt;
  while (end - 1 > first && is_empty(end - 1)) --end;
  const auto include_if_free = [&](double x, double y) {
    const std::uint32_t facing = wedges.facing(RealVec{x, y});
    const std::uint32_t k = (facing + wedges.size() - arc.first) % wedges.size();
    if (first <= k && k < end && wedges.depth(facing, {x, y}) <= 0) include(x, y);
  };
  constexpr std::uint32_t kMany = 4;
  if (end - first > kMany) {
    include_if_free(box.low_x, box.low_y);
    include_if_free(box.high_x, box.low_y);
    include_if_free(box.low_x, box.high_y);
    include_if_free(box.high_x, box.high_y);
  }
  for (std::uint32_t k = first + 1; k + 1 < end && !is_all_of(found, box); ++k) {
    if (!wedges.lies_within((arc.first + k) % wedges.size(), box, found)) (void)is_empty(k);
  }
  if (arc.count < wedges.size()) arc = {(arc.first + first) % wedges.size(), end - first};
  return found;
}

bool Relaxation::look(Node& node, RingState& ring) {
  ++work_.looks;
  const WedgeRing& wedges = problem_->rings[ring.ring];
  const bool whole = ring.arc.count == wedges.size();
  const RealBox box = pair_box(node, ring);
  ring.looked_at = box;
  ring.hull_begin = RingState::kNone;
  if (whole && apart(box, wedges.box())) {
    ring.clear = true;
    return true;
  }
  if (whole && has_free_corners(box, wedges)) {
    ring.hull_begin = ring.hull_end = 0;
    return true;
  }
  const Reasons why = ring.why | why_pair_box(node, ring);
  const std::uint32_t count = ring.arc.count;
  const auto found = trim(wedges, ring.arc, box);
  if (!found) conflict_ = why;
  if (ring.arc.count != count) ring.why = why;
  // Differences are whole, so the box may be rounded inwards, as far as clipping is exact.
  if (!found || !raise_to(node, ring, whole_within(*found), why)) {
    ++conflicts_.of_rings[ring.ring];
    ++conflicts_.of_pairs[pair_of(ring)];
    return false;
  }
  ring.looked_at = pair_box(node, ring);
  return true;
}

// Moves the ends of the bodies' ranges from where fixed pieces leave them no place.
bool Relaxation::stays_free(Node& node) {
  for (std::uint32_t body = 0; body < problem_->free_cells.size(); ++body) {
    const std::uint32_t variant = node.variant[body];
    if (variant == Node::kUndecided || !problem_->free_cells[body][variant]) continue;
    RingState own;
    own.first = problem_->world();
    own.second = body;
    const RealBox box = pair_box(node, own);
    const auto found = problem_->free_cells[body][variant]->within(box);
    if (found && is_all_of(*found, box)) continue;
    const Reasons why = node.why_variant[body] | why_pair_box(node, own);
    if (!found) conflict_ = why;
    if (!found || !raise_to(node, own, *found, why)) return false;
  }
  return true;
}

bool Relaxation::propagate(Node& node) {
  bool on_lines = false;  // the lines have been looked at since the last look at a ring
  for (int round = 0; round < tuning_.propagations; ++round) {
    bool any = false;
    if (!stays_free(node)) return false;
    for (RingState& ring : node.rings) {
      if (ring.clear || !shrank(ring.looked_at, pair_box(node, ring), tuning_.shrink)) continue;
      if (!look(node, ring)) return false;
      any = true;
    }
    if (!any && on_lines) break;
    if (!any && !fit_on_lines(node)) return false;
    on_lines = !any;
  }
  return true;
}

}  // namespace selvage::packing::branching
