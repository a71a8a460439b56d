// The linear program of a node: its rows, its solution, and what they prove.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/packing/branching/relaxation.h"
#include "core/packing/cells/box_sides.h"
#include "core/packing/cells/hull.h"

namespace selvage::packing::branching {

using cells::BoxSides;

// The corners of the arc's cells that can be corners of their hull: of those on one side of the box, only the two
// outermost.  The cells at the arc's ends and the free corners of the box mostly span a hull that has all other cells
// in it, which are then not clipped.
void Relaxation::gather(const RingState& ring, const RealBox& box) {
  const WedgeRing& wedges = problem_->rings[ring.ring];
  points_.clear();
  BoxSides sides{box};
  const auto take = [&](std::uint32_t k) {
    Cell cell;
    if (!wedges.clip((ring.arc.first + k) % wedges.size(), box, cell)) return;
    for (std::size_t c = 0; c < cell.count; ++c) {
      if (!sides.include(cell.corner(c))) points_.push_back(cell.corner(c));
    }
  };
  const auto [first, end] = wedges.part_facing(ring.arc, box);
  if (first < end) take(first);
  if (first + 1 < end) take(end - 1);
  if (first + 2 < end) {
    for (const RealVec corner : cells::corners_of(box)) {
      const std::uint32_t facing = wedges.facing(corner);
      const std::uint32_t k = (facing + wedges.size() - ring.arc.first) % wedges.size();
      if (k < ring.arc.count && wedges.depth(facing, corner) <= 0) (void)sides.include(corner);
    }
    const bool spanned = sides.set_chords(chords_);
    for (std::uint32_t k = first + 1; k + 1 < end; ++k) {
      const std::uint32_t wedge = (ring.arc.first + k) % wedges.size();
      if (!spanned || !wedges.lies_within(wedge, chords_)) take(k);
    }
  }
  sides.append_corners(points_);
}

void Relaxation::make_hull(const Node& node, RingState& ring) {
  ring.hull_begin = static_cast<std::uint32_t>(hulls_.size());
  if (ring.arc.count == 1) {
    for (const HalfPlane& side : problem_->rings[ring.ring].sides(ring.arc.first)) cells::append_side(side, hulls_);
  } else {
    gather(ring, pair_box(node, ring));
    cells::append_hull(points_, hulls_);
  }
  ring.hull_end = static_cast<std::uint32_t>(hulls_.size());
}

const Ranges& Relaxation::ranges(const Node& node) {
  ranges_.bodies.clear();
  ranges_.why.clear();
  ranges_.low_length = columns_.low_length;
  ranges_.high_length = ceiling_;
  const std::size_t world = problem_->world();
  for (std::size_t body = 0; body < world; ++body) {
    ranges_.bodies.push_back(
        {node.x.lower(world, body), node.y.lower(world, body), node.x.upper(world, body), node.y.upper(world, body)});
    if (wide_.empty()) continue;
    ranges_.why.push_back({node.x.why_lower(world, body), node.y.why_lower(world, body), node.x.why_upper(world, body),
                           node.y.why_upper(world, body)});
  }
  ranges_.wide = wide_;
  return ranges_;
}

// Whether the solution violates, by more than `least`, a bound on how far another body is ahead of body `a`.
bool Relaxation::violates_bounds(const Node& node, std::uint32_t a, double least) const {
  const RealVec own = positions_[a];
  const double* const x = node.x.lower_from(a);
  const double* const y = node.y.lower_from(a);
  double most = -1;
  for (std::size_t b = 0; b < positions_.size(); ++b) {
    most = std::max(most, x[b] - (positions_[b].x - own.x));
    most = std::max(most, y[b] - (positions_[b].y - own.y));
  }
  return most > least;
}

bool Relaxation::add_violated_bounds(Node& node) {
  const double least = tuning_.violated / columns_.scale;
  const auto world = problem_->world();
  bool any = false;
  for (std::uint32_t a = 0; a <= world; ++a) {
    if (!violates_bounds(node, a, least)) continue;
    for (std::uint32_t b = 0; b <= world; ++b) {
      if (a == b) continue;
      const RealVec way{positions_[b].x - positions_[a].x, positions_[b].y - positions_[a].y};
      if (way.x < node.x.lower(a, b) - least) {
        node.program.add(columns_, {a, b, false, {1, 0, node.x.lower(a, b)}, node.x.why_lower(a, b)});
        any = true;
      }
      if (way.y < node.y.lower(a, b) - least) {
        node.program.add(columns_, {a, b, false, {0, 1, node.y.lower(a, b)}, node.y.why_lower(a, b)});
        any = true;
      }
    }
  }
  return any;
}

bool Relaxation::add_violated_hull(Node& node, RingState& ring) {
  const RealVec way{positions_[ring.second].x - positions_[ring.first].x,
                    positions_[ring.second].y - positions_[ring.first].y};
  const WedgeRing& wedges = problem_->rings[ring.ring];
  if (ring.arc.count == wedges.size() && wedges.is_beside(way)) return false;
  const std::uint32_t facing = wedges.facing(way);
  const bool within = (facing + wedges.size() - ring.arc.first) % wedges.size() < ring.arc.count;
  if (within && wedges.depth(facing, way) <= 0) return false;
  if (ring.hull_begin == RingState::kNone) make_hull(node, ring);
  const HalfPlane* worst = nullptr;
  double least = -tuning_.violated / columns_.scale;
  for (std::uint32_t k = ring.hull_begin; k < ring.hull_end; ++k) {
    const double room = hulls_[k].room(way);
    if (room >= least) continue;
    least = room;
    worst = &hulls_[k];
  }
  if (worst) {
    // The sides of a single wedge hold in any box.
    const Reasons why = ring.arc.count == 1 ? ring.why : ring.why | why_pair_box(node, ring);
    node.program.add(columns_, {ring.first, ring.second, false, *worst, why});
  }
  return worst != nullptr;
}

bool Relaxation::add_violated_rows(Node& node) {
  for (std::uint32_t body = 0; body < problem_->world(); ++body) positions_[body] = position(node, body);
  positions_[problem_->world()] = {};
  bool any = add_violated_bounds(node);
  for (RingState& ring : node.rings) {
    if (ring.clear || (ring.hull_begin == ring.hull_end && ring.hull_begin != RingState::kNone)) continue;
    if (add_violated_hull(node, ring)) any = true;
  }
  return any;
}

void Relaxation::start_program(Node& node) {
  node.program = Dictionary{columns_, problem_->minimises_length};
  if (!problem_->minimises_length) return;
  for (std::uint32_t body = 0; body < problem_->bodies.size(); ++body) {
    node.program.add(columns_, {body, body, true, {1, 0, least_width(node, body)}, node.why_variant[body]});
  }
}

bool Relaxation::is_refuted(const Node& node) {
  const Ranges& all = ranges(node);
  const auto multipliers = node.program.refuting();
  if (!refutes(multipliers, all)) return false;
  conflict_ = why_refuted(multipliers, all);
  return true;
}

bool Relaxation::is_too_long(const Node& node) {
  const Ranges& all = ranges(node);
  const auto multipliers = node.program.bounding();
  if (least_length(multipliers, all) <= ceiling_) return false;
  conflict_ = why_longer(multipliers, all, ceiling_);
  return true;
}

void Relaxation::raise_bound(Node& node) {
  const Ranges& all = ranges(node);
  const auto multipliers = node.program.bounding();
  const double least = least_length(multipliers, all);
  if (least <= node.bound) return;
  node.bound = least;
  node.why_bound = why_longer(multipliers, all, std::nextafter(least, 0.0));
}

bool Relaxation::settle(Node& node) {
  if (!propagate(node)) return false;
  bool fresh = false;
  double ceiling = problem_->minimises_length ? ceiling_ : std::numeric_limits<double>::infinity();
  // What rounding has spoilt is computed anew once, from no rows.
  const auto start_again = [&] {
    if (fresh) ++work_.unproved;
    if (!fresh) start_program(node);
    return !std::exchange(fresh, true);
  };
  for (int count = 0; count < tuning_.programs; ++count) {
    switch (node.program.solve(columns_, ceiling, work_.pivots)) {
      case Dictionary::End::kInfeasible:
        if (is_refuted(node)) return false;
        if (!start_again()) return true;
        break;
      case Dictionary::End::kAboveCeiling:
        if (is_too_long(node)) return false;
        ceiling = std::numeric_limits<double>::infinity();
        break;
      case Dictionary::End::kTrouble:
        if (!start_again()) return true;
        break;
      case Dictionary::End::kOptimal:
        if (!add_violated_rows(node)) count = tuning_.programs;
        break;
    }
  }
  if (!problem_->minimises_length) return true;
  raise_bound(node);
  conflict_ = node.why_bound;
  return node.bound <= ceiling_;
}

}  // namespace selvage::packing::branching
