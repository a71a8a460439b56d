#include "core/packing/branching/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/packing/cells/hull.h"

namespace selvage::packing::branching {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

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
// Whether `now` is much smaller than `before`.
bool shrank(const RealBox& before, const RealBox& now, double part) {
  const double least = part * std::max({before.width(), before.height(), 1.0});
  return now.low_x > before.low_x + least || now.high_x < before.high_x - least || now.low_y > before.low_y + least ||
         now.high_y < before.high_y - least;
}

}  // namespace

Work& Work::operator+=(const Work& other) {
  nodes += other.nodes;
  pivots += other.pivots;
  looks += other.looks;
  unproved += other.unproved;
  return *this;
}

Columns columns_of(const Problem& problem) {
  Columns columns{.bodies = problem.bodies.size(), .low = {}, .low_length = problem.least_length};
  double extent = 1;
  for (const Body& body : problem.bodies) {
    RealVec low{kInfinite, kInfinite};
    for (const BodyVariant& variant : body.variants) {
      low = {std::min(low.x, variant.range.low_x), std::min(low.y, variant.range.low_y)};
      extent = std::max(extent, variant.range.height());
    }
    columns.low.push_back(low);
  }
  columns.scale = 1 / std::exp2(std::ceil(std::log2(extent)));
  return columns;
}

Relaxation::Relaxation(const Problem& problem, const BranchTuning& tuning)
    : problem_{&problem}, tuning_{tuning}, columns_{columns_of(problem)}, positions_(problem.bodies.size() + 1) {}

std::optional<Node> Relaxation::root(double ceiling) {
  const std::size_t count = problem_->bodies.size();
  ceiling_ = ceiling;
  Node node{.x = DifferenceBounds{count},
            .y = DifferenceBounds{count},
            .variant = std::vector<std::uint32_t>(count, Node::kUndecided),
            .rings = {},
            .program = Dictionary{columns_, problem_->minimises_length},
            .bound = problem_->least_length};
  const std::size_t world = problem_->world();
  for (std::uint32_t body = 0; body < count; ++body) {
    RealBox range{kInfinite, kInfinite, -kInfinite, -kInfinite};
    for (const BodyVariant& variant : problem_->bodies[body].variants) {
      range = {std::min(range.low_x, variant.range.low_x), std::min(range.low_y, variant.range.low_y),
               std::max(range.high_x, variant.range.high_x), std::max(range.high_y, variant.range.high_y)};
    }
    if (!node.x.raise(world, body, range.low_x) || !node.x.raise(body, world, -range.high_x) ||
        !node.y.raise(world, body, range.low_y) || !node.y.raise(body, world, -range.high_y))
      return std::nullopt;
  }
  start_program(node);
  for (std::uint32_t body = 0; body < count; ++body) {
    if (problem_->bodies[body].variants.size() == 1 && !decide(node, body, 0)) return std::nullopt;
  }
  if (!limit_length(node) || !settle(node)) return std::nullopt;
  return node;
}

bool Relaxation::decide(Node& node, std::uint32_t body, std::uint32_t variant) {
  const Body& decided = problem_->bodies[body];
  const BodyVariant& chosen = decided.variants[variant];
  const std::size_t world = problem_->world();
  node.variant[body] = variant;
  if (!node.x.raise(world, body, chosen.range.low_x) || !node.x.raise(body, world, -chosen.range.high_x) ||
      !node.y.raise(world, body, chosen.range.low_y) || !node.y.raise(body, world, -chosen.range.high_y))
    return false;
  if (problem_->minimises_length && decided.variants.size() > 1) {
    node.program.add(columns_, {body, body, true, {1, 0, chosen.width}});
  }
  if (!order_alike(node, body)) return false;
  const Chosen own{body, variant};
  if (!activate_pair(node, {problem_->world(), 0}, own)) return false;
  for (std::uint32_t other = 0; other < problem_->bodies.size(); ++other) {
    if (other == body || node.variant[other] == Node::kUndecided) continue;
    const Chosen theirs{other, node.variant[other]};
    if (!(other < body ? activate_pair(node, theirs, own) : activate_pair(node, own, theirs))) return false;
  }
  return true;
}

// Bodies of one kind are interchangeable: their variants ascend with their numbers, and so do their x in one variant.
bool Relaxation::order_alike(Node& node, std::uint32_t body) {
  const std::uint32_t own = node.variant[body];
  for (std::uint32_t other = 0; other < problem_->bodies.size(); ++other) {
    const std::uint32_t theirs = node.variant[other];
    if (other == body || theirs == Node::kUndecided || problem_->bodies[other].kind != problem_->bodies[body].kind)
      continue;
    const bool before = other < body;
    if (before ? theirs > own : own > theirs) return false;
    if (theirs != own) continue;
    if (!node.x.raise(before ? other : body, before ? body : other, 0)) return false;
  }
  return true;
}

bool Relaxation::activate_pair(Node& node, const Chosen& first, const Chosen& second) {
  const auto found = problem_->between.find({first, second});
  if (found == problem_->between.end()) return true;
  for (const std::uint32_t ring : found->second) {
    node.rings.push_back(
        {.ring = ring, .first = first.body, .second = second.body, .arc = problem_->rings[ring].whole()});
    if (!look(node, node.rings.back())) return false;
  }
  return true;
}

double Relaxation::least_width(const Node& node, std::uint32_t body) const {
  const std::vector<BodyVariant>& variants = problem_->bodies[body].variants;
  if (node.variant[body] != Node::kUndecided) return variants[node.variant[body]].width;
  double width = kInfinite;
  for (const BodyVariant& variant : variants) width = std::min(width, variant.width);
  return width;
}

bool Relaxation::limit_length(Node& node) {
  if (!problem_->minimises_length) return true;
  for (std::uint32_t body = 0; body < problem_->bodies.size(); ++body) {
    const double latest = std::floor(ceiling_) - least_width(node, body);
    if (!node.x.raise(body, problem_->world(), -latest)) return false;
  }
  if (const auto half = problem_->left_half) {
    const BodyVariant& variant = problem_->bodies[*half].variants.front();
    // Rounded up: a position and its mirror image add up to a whole number.
    const double middle = std::ceil((variant.range.low_x + std::floor(ceiling_) - variant.width) / 2);
    if (!node.x.raise(*half, problem_->world(), -middle)) return false;
  }
  return true;
}

bool Relaxation::keep_arc(Node& node, std::size_t ring, Arc arc) {
  node.rings[ring].arc = arc;
  return look(node, node.rings[ring]);
}

RealVec Relaxation::position(const Node& node, std::uint32_t body) const {
  return body == problem_->world() ? RealVec{} : node.program.position(columns_, body);
}

RealVec Relaxation::difference(const Node& node, const RingState& ring) const {
  const RealVec first = position(node, ring.first);
  const RealVec second = position(node, ring.second);
  return {second.x - first.x, second.y - first.y};
}

std::vector<Row> Relaxation::exact_rows(const Node& node) const {
  std::vector<Row> rows;
  for (const RingState& ring : node.rings) {
    const WedgeRing& wedges = problem_->rings[ring.ring];
    const std::uint32_t wedge = ring.arc.count == 1 ? ring.arc.first : wedges.facing(difference(node, ring));
    rows.push_back({ring.first, ring.second, false, wedges.line(wedge)});
  }
  return rows;
}

RealBox Relaxation::pair_box(const Node& node, const RingState& ring) const {
  return {node.x.lower(ring.first, ring.second), node.y.lower(ring.first, ring.second),
          node.x.upper(ring.first, ring.second), node.y.upper(ring.first, ring.second)};
}

bool Relaxation::raise_to(Node& node, const RingState& ring, const RealBox& box) {
  return node.x.raise(ring.first, ring.second, box.low_x) && node.x.raise(ring.second, ring.first, -box.high_x) &&
         node.y.raise(ring.first, ring.second, box.low_y) && node.y.raise(ring.second, ring.first, -box.high_y);
}

// The box of the arc's cells within `box`; nothing when they are all empty.  Empty cells at the ends are cut off, but
// for a whole ring, which has no ends.
std::optional<RealBox> Relaxation::trim(const WedgeRing& wedges, Arc& arc, const RealBox& box) {
  RealBox found{kInfinite, kInfinite, -kInfinite, -kInfinite};
  Cell cell;
  const auto is_empty = [&](std::uint32_t k) {
    const std::uint32_t at = arc.first + k;
    if (!wedges.clip(at < wedges.size() ? at : at - wedges.size(), box, cell)) return true;
    for (std::size_t c = 0; c < cell.count; ++c) {
      found = {std::min(found.low_x, cell.x[c]), std::min(found.low_y, cell.y[c]), std::max(found.high_x, cell.x[c]),
               std::max(found.high_y, cell.y[c])};
    }
    return false;
  };
  std::uint32_t first = 0;
  while (first < arc.count && is_empty(first)) ++first;
  if (first == arc.count) return std::nullopt;
  std::uint32_t last = arc.count - 1;
  while (last > first && is_empty(last)) --last;
  for (std::uint32_t k = first + 1; k < last && !is_all_of(found, box); ++k) (void)is_empty(k);
  if (arc.count < wedges.size()) arc = {(arc.first + first) % wedges.size(), last - first + 1};
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
  const auto found = trim(wedges, ring.arc, box);
  if (!found) return false;
  // Differences are whole, so the box may be rounded inwards, as far as clipping is exact.
  const RealBox inner{std::ceil(found->low_x - cells::kRounding), std::ceil(found->low_y - cells::kRounding),
                      std::floor(found->high_x + cells::kRounding), std::floor(found->high_y + cells::kRounding)};
  if (!raise_to(node, ring, inner)) return false;
  ring.looked_at = pair_box(node, ring);
  return true;
}

bool Relaxation::propagate(Node& node) {
  for (int round = 0; round < tuning_.propagations; ++round) {
    bool any = false;
    for (RingState& ring : node.rings) {
      if (ring.clear || !shrank(ring.looked_at, pair_box(node, ring), tuning_.shrink)) continue;
      if (!look(node, ring)) return false;
      any = true;
    }
    if (!any) break;
  }
  return true;
}

void Relaxation::gather(const RingState& ring, const RealBox& box) {
  const WedgeRing& wedges = problem_->rings[ring.ring];
  points_.clear();
  Cell cell;
  for (std::uint32_t k = 0; k < ring.arc.count; ++k) {
    if (!wedges.clip((ring.arc.first + k) % wedges.size(), box, cell)) continue;
    for (std::size_t c = 0; c < cell.count; ++c) points_.push_back(cell.corner(c));
  }
}

void Relaxation::make_hull(const Node& node, RingState& ring) {
  gather(ring, pair_box(node, ring));
  ring.hull_begin = static_cast<std::uint32_t>(hulls_.size());
  cells::append_hull(points_, hulls_);
  ring.hull_end = static_cast<std::uint32_t>(hulls_.size());
}

Ranges Relaxation::ranges(const Node& node) const {
  Ranges all{{}, columns_.low_length, ceiling_};
  const std::size_t world = problem_->world();
  for (std::size_t body = 0; body < world; ++body) {
    all.bodies.push_back(
        {node.x.lower(world, body), node.y.lower(world, body), node.x.upper(world, body), node.y.upper(world, body)});
  }
  return all;
}

bool Relaxation::add_violated_bounds(Node& node) {
  const double least = tuning_.violated / columns_.scale;
  const auto world = problem_->world();
  bool any = false;
  for (std::uint32_t a = 0; a <= world; ++a) {
    for (std::uint32_t b = 0; b <= world; ++b) {
      if (a == b) continue;
      const RealVec way{positions_[b].x - positions_[a].x, positions_[b].y - positions_[a].y};
      if (way.x < node.x.lower(a, b) - least) {
        node.program.add(columns_, {a, b, false, {1, 0, node.x.lower(a, b)}});
        any = true;
      }
      if (way.y < node.y.lower(a, b) - least) {
        node.program.add(columns_, {a, b, false, {0, 1, node.y.lower(a, b)}});
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
  if (worst) node.program.add(columns_, {ring.first, ring.second, false, *worst});
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
    node.program.add(columns_, {body, body, true, {1, 0, least_width(node, body)}});
  }
}

bool Relaxation::settle(Node& node) {
  if (!propagate(node)) return false;
  bool fresh = false;
  double ceiling = problem_->minimises_length ? ceiling_ : kInfinite;
  // What rounding has spoilt is computed anew once, from no rows.
  const auto start_again = [&] {
    if (fresh) ++work_.unproved;
    if (!fresh) start_program(node);
    return !std::exchange(fresh, true);
  };
  for (int count = 0; count < tuning_.programs; ++count) {
    switch (node.program.solve(columns_, ceiling, work_.pivots)) {
      case Dictionary::End::kInfeasible:
        if (refutes(node.program.refuting(), ranges(node))) return false;
        if (!start_again()) return true;
        break;
      case Dictionary::End::kAboveCeiling:
        if (least_length(node.program.bounding(), ranges(node)) > ceiling_) return false;
        ceiling = kInfinite;
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
  node.bound = std::max(node.bound, least_length(node.program.bounding(), ranges(node)));
  return node.bound <= ceiling_;
}

}  // namespace selvage::packing::branching
