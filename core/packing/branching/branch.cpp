#include "core/packing/branching/branch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace selvage::packing::branching {
namespace {

// The ring to split, by its place in the node, and the wedge that the solution's ray passes.
struct Split {
  std::size_t ring{};
  std::uint32_t wedge{};
};

// How deep the solution lies in a ring, and the wedge that its ray passes.
struct Depth {
  double depth{};
  std::uint32_t wedge{};
};

// Nothing for a ring that cannot be split, or in which the depth is at most `least`.
std::optional<Depth> depth_in(const Relaxation& relaxation, const Problem& problem, const Node& node,
                              const RingState& ring, double least) {
  if (ring.clear || ring.arc.count == 1) return std::nullopt;
  const WedgeRing& wedges = problem.rings[ring.ring];
  const RealVec way = relaxation.difference(node, ring);
  if (least >= 0 && wedges.is_beside(way)) return std::nullopt;
  const std::uint32_t wedge = wedges.facing(way);
  const double depth = wedges.depth(wedge, way);
  return depth > least ? std::optional{Depth{depth, wedge}} : std::nullopt;
}

// By how much the solution overlaps, over all rings that can be split.
double overlap_in(const Relaxation& relaxation, const Problem& problem, const Node& node) {
  double sum = 0;
  for (const RingState& ring : node.rings) {
    if (const auto found = depth_in(relaxation, problem, node, ring, 0)) sum += found->depth;
  }
  return sum;
}

bool within(Arc arc, std::uint32_t wedge, std::uint32_t size) {
  return (wedge + size - arc.first) % size < arc.count;
}

std::optional<std::uint32_t> undecided(const Problem& problem, const Node& node) {
  std::optional<std::uint32_t> largest;
  for (std::uint32_t body = 0; body < problem.world(); ++body) {
    if (node.variant[body] != Node::kUndecided) continue;
    if (!largest || problem.bodies[body].area > problem.bodies[*largest].area) largest = body;
  }
  return largest;
}

// What splitting a ring promises, by its depth and the area of its box.  Where any layout will do, it matters less how
// deep a solution happens to lie than how much the two bodies are in each other's way.
double promise(double depth, double area, const Problem& problem) {
  return problem.minimises_length ? depth * std::sqrt(area) : std::sqrt(std::sqrt(depth)) * area;
}

std::optional<Split> best_split(const Relaxation& relaxation, const Problem& problem, const Node& node, double least) {
  std::optional<Split> split;
  double most = 0;
  for (std::size_t k = 0; k < node.rings.size(); ++k) {
    const RingState& ring = node.rings[k];
    const auto found = depth_in(relaxation, problem, node, ring, least);
    // A solution outside the ring but beyond the arc is in the hull of the arc's cells only.
    if (!found) continue;
    const RealBox& box = problem.rings[ring.ring].box();
    const double weight =
        promise(found->depth - least, box.width() * box.height(), problem) * (1.0 + relaxation.conflicts(ring));
    if (weight <= most) continue;
    most = weight;
    split = Split{k, found->wedge};
  }
  return split;
}

std::vector<Arc> quarters(const WedgeRing& wedges, RealVec way) {
  std::vector<std::uint32_t> cuts;
  for (int quarter = 0; quarter < 4; ++quarter) cuts.push_back(wedges.corner_near(way, quarter));
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  std::vector<Arc> arcs;
  for (std::size_t k = 0; k < cuts.size(); ++k) {
    const std::uint32_t end = k + 1 < cuts.size() ? cuts[k + 1] : cuts[0] + wedges.size();
    arcs.push_back({cuts[k], end - cuts[k]});
  }
  return arcs;
}

std::vector<Arc> arcs_of(const WedgeRing& wedges, Arc arc, std::uint32_t wedge, RealVec way,
                         const BranchTuning& tuning) {
  const std::uint32_t size = wedges.size();
  std::vector<Arc> arcs;
  if (arc.count <= tuning.few_wedges) {
    for (std::uint32_t k = 0; k < arc.count; ++k) arcs.push_back({(arc.first + k) % size, 1});
    return arcs;
  }
  if (arc.count == size) return quarters(wedges, way);
  std::uint32_t cut = arc.count / 2;
  if (within(arc, wedge, size)) {
    const std::uint32_t near = (wedges.corner_near(way, 0) + size - arc.first) % size;
    if (near > 0 && near < arc.count) cut = near;
  }
  return {{arc.first, cut}, {(arc.first + cut) % size, arc.count - cut}};
}

// Of the children, those that promise most come last: the shortest or, where any layout will do, those whose solutions
// overlap least.
void sort_by_promise(const Relaxation& relaxation, const Problem& problem, std::vector<Node>& nodes) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const Node& node = nodes[k];
    const double price = problem.minimises_length ? node.program.cost() : overlap_in(relaxation, problem, node);
    order.emplace_back(-price, k);
  }
  std::sort(order.begin(), order.end());
  std::vector<Node> sorted;
  sorted.reserve(nodes.size());
  for (const auto& [price, k] : order) sorted.push_back(std::move(nodes[k]));
  nodes = std::move(sorted);
}

}  // namespace

Children children(Relaxation& relaxation, const Problem& problem, const Node& node, const BranchTuning& tuning,
                  double depth) {
  Children found;
  bool refuted = false;
  const double slack = tuning.slack / relaxation.columns().scale;
  const Reasons own = programs::decision(node.depth);
  const auto attempt = [&](const auto& restrict) {
    if (refuted) return;
    Node child = relaxation.copy(node);
    ++child.depth;
    child.program.drop_slack_rows(relaxation.columns(), slack);
    if (restrict(child) && relaxation.settle(child)) {
      found.nodes.push_back(std::move(child));
      return;
    }
    relaxation.give_back(std::move(child));
    refuted = (relaxation.conflict() & own) == 0;
    found.conflict =
        refuted ? relaxation.conflict() : found.conflict | programs::without(relaxation.conflict(), node.depth);
  };
  if (const auto body = undecided(problem, node)) {
    for (std::uint32_t variant = 0; variant < problem.bodies[*body].variants.size(); ++variant) {
      attempt([&](Node& child) { return relaxation.decide(child, *body, variant) && relaxation.limit_length(child); });
    }
  } else {
    const auto split = best_split(relaxation, problem, node, depth);
    found.leaf = !split;
    if (!split) return found;
    const RingState& ring = node.rings[split->ring];
    found.conflict = ring.why;
    const WedgeRing& wedges = problem.rings[ring.ring];
    const RealVec way = relaxation.difference(node, ring);
    for (const Arc arc : arcs_of(wedges, ring.arc, split->wedge, way, tuning)) {
      attempt([&](Node& child) { return relaxation.keep_arc(child, split->ring, arc); });
    }
  }
  if (refuted) found.nodes.clear();
  sort_by_promise(relaxation, problem, found.nodes);
  return found;
}

}  // namespace selvage::packing::branching
