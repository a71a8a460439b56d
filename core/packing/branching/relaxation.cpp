#include "core/packing/branching/relaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace selvage::packing::branching {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kOfThePair = 0.1;  // what a conflict of other rings of a pair counts

}  // namespace

Work& Work::operator+=(const Work& other) {
  nodes += other.nodes;
  pivots += other.pivots;
  looks += other.looks;
  skipped += other.skipped;
  unproved += other.unproved;
  return *this;
}

void Conflicts::add_since(const Conflicts& before, const Conflicts& now) {
  const auto add = [](std::vector<std::uint32_t>& counts, const auto& from, const auto& to) {
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k] += to[k] - from[k];
  };
  add(of_rings, before.of_rings, now.of_rings);
  add(of_pairs, before.of_pairs, now.of_pairs);
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
    : problem_{&problem},
      tuning_{tuning},
      columns_{columns_of(problem)},
      positions_(problem.bodies.size() + 1),
      conflicts_{problem} {}

std::optional<Node> Relaxation::undecided_root(double ceiling) {
  const std::size_t count = problem_->bodies.size();
  ceiling_ = ceiling;
  Node node{.x = DifferenceBounds{count},
            .y = DifferenceBounds{count},
            .variant = std::vector<std::uint32_t>(count, Node::kUndecided),
            .why_variant = std::vector<Reasons>(count),
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
  return node;
}

std::optional<Node> Relaxation::root(double ceiling) {
  auto node = undecided_root(ceiling);
  if (!node) return std::nullopt;
  for (std::uint32_t body = 0; body < problem_->world(); ++body) {
    if (problem_->bodies[body].variants.size() == 1 && !decide(*node, body, 0)) return std::nullopt;
  }
  if (!limit_length(*node) || !settle(*node)) return std::nullopt;
  return node;
}

std::optional<Node> Relaxation::root_in(const Vicinity& vicinity, double ceiling) {
  auto node = undecided_root(ceiling);
  if (!node) return std::nullopt;
  const std::uint32_t world = problem_->world();
  const double reach = vicinity.reach;
  for (std::uint32_t body = 0; body < world; ++body) {
    const RealVec at = vicinity.positions[body];
    if (!node->x.raise(world, body, std::floor(at.x - reach)) ||
        !node->x.raise(body, world, -std::ceil(at.x + reach)) ||
        !node->y.raise(world, body, std::floor(at.y - reach)) || !node->y.raise(body, world, -std::ceil(at.y + reach)))
      return std::nullopt;
  }
  for (std::uint32_t body = 0; body < world; ++body) {
    if (!decide(*node, body, vicinity.variant[body])) return std::nullopt;
  }
  if (!limit_length(*node) || !settle(*node)) return std::nullopt;
  return node;
}

bool Relaxation::decide(Node& node, std::uint32_t body, std::uint32_t variant) {
  const Body& decided = problem_->bodies[body];
  const BodyVariant& chosen = decided.variants[variant];
  const std::size_t world = problem_->world();
  node.variant[body] = variant;
  const Reasons why = node.depth == 0 ? programs::kUnconditional : programs::decision(node.depth - 1);
  node.why_variant[body] = why;
  if (!raise(node.x, world, body, chosen.range.low_x, why) || !raise(node.x, body, world, -chosen.range.high_x, why) ||
      !raise(node.y, world, body, chosen.range.low_y, why) || !raise(node.y, body, world, -chosen.range.high_y, why))
    return false;
  if (problem_->minimises_length && decided.variants.size() > 1) {
    node.program.add(columns_, {body, body, true, {1, 0, chosen.width}, why});
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

// Bodies of one kind are interchangeable: their variants ascend with their numbers, and so do their x, or y, in one
// variant.
bool Relaxation::order_alike(Node& node, std::uint32_t body) {
  const std::uint32_t own = node.variant[body];
  for (std::uint32_t other = 0; other < problem_->bodies.size(); ++other) {
    const std::uint32_t theirs = node.variant[other];
    if (other == body || theirs == Node::kUndecided || problem_->bodies[other].kind != problem_->bodies[body].kind)
      continue;
    const bool before = other < body;
    const Reasons why = node.why_variant[body] | node.why_variant[other];
    conflict_ = why;
    if (before ? theirs > own : own > theirs) return false;
    if (theirs != own) continue;
    auto& bounds = problem_->is_ordered_by_y(body, own) ? node.y : node.x;
    if (!raise(bounds, before ? other : body, before ? body : other, 0, why)) return false;
  }
  return true;
}

bool Relaxation::activate_pair(Node& node, const Chosen& first, const Chosen& second) {
  const auto found = problem_->between.find({first, second});
  if (found == problem_->between.end()) return true;
  const auto why = [&](std::uint32_t body) {
    return body == problem_->world() ? programs::kUnconditional : node.why_variant[body];
  };
  for (const std::uint32_t ring : found->second) {
    node.rings.push_back({.ring = ring,
                          .first = first.body,
                          .second = second.body,
                          .arc = problem_->rings[ring].whole(),
                          .why = why(first.body) | why(second.body)});
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
    if (!raise(node.x, body, problem_->world(), -latest, node.why_variant[body])) return false;
  }
  if (const auto half = problem_->left_half) {
    const BodyVariant& variant = problem_->bodies[*half].variants.front();
    // Rounded up: a position and its mirror image add up to a whole number.
    const double middle = std::ceil((variant.range.low_x + std::floor(ceiling_) - variant.width) / 2);
    if (!raise(node.x, *half, problem_->world(), -middle, programs::kUnconditional)) return false;
  }
  return true;
}

bool Relaxation::keep_arc(Node& node, std::size_t ring, Arc arc) {
  node.rings[ring].arc = arc;
  node.rings[ring].why |= programs::decision(node.depth - 1);
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
    const auto add = [&](std::uint32_t k) { rows.push_back({ring.first, ring.second, false, wedges.line(k)}); };
    add(wedge);
    if (wedges.is_notch(wedge)) add(wedges.previous(wedge));
    if (wedges.is_notch(wedges.next(wedge))) add(wedges.next(wedge));
  }
  return rows;
}

Node Relaxation::copy(const Node& node) {
  if (spare_.empty()) return node;
  Node copy = std::move(spare_.back());
  spare_.pop_back();
  copy = node;
  return copy;
}

void Relaxation::give_back(Node node) {
  constexpr std::size_t kMost = 16;
  if (spare_.size() < kMost) spare_.push_back(std::move(node));
}

bool Relaxation::raise(DifferenceBounds& bounds, std::size_t a, std::size_t b, double bound, Reasons why) {
  if (bounds.raise(a, b, bound, why)) return true;
  conflict_ = why | bounds.why_upper(a, b);
  return false;
}

double Relaxation::conflicts(const RingState& ring) const {
  return conflicts_.of_rings[ring.ring] + kOfThePair * conflicts_.of_pairs[pair_of(ring)];
}

void Relaxation::begin_at(Node& node) {
  node.depth = 0;
  node.x.forget_why();
  node.y.forget_why();
  node.program.forget_why();
  node.why_bound = programs::kUnconditional;
  std::fill(node.why_variant.begin(), node.why_variant.end(), programs::kUnconditional);
  for (RingState& ring : node.rings) ring.why = programs::kUnconditional;
  wide_ = ranges(node).bodies;
}

}  // namespace selvage::packing::branching
