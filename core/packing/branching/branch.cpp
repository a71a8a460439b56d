#include "core/packing/branching/branch.h"

#include <algorithm>
#include <cmath>

namespace selvage::packing::branching {
namespace {

// The ring to split, by its place in the node, and the wedge that the solution's ray passes.
struct Split {
  std::size_t ring{};
  std::uint32_t wedge{};
};

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

std::optional<Split> deepest(const Relaxation& relaxation, const Problem& problem, const Node& node, double least) {
  std::optional<Split> split;
  double most = 0;
  for (std::size_t k = 0; k < node.rings.size(); ++k) {
    const RingState& ring = node.rings[k];
    if (ring.clear || ring.arc.count == 1) continue;
    const WedgeRing& wedges = problem.rings[ring.ring];
    const RealVec way = relaxation.difference(node, ring);
    const std::uint32_t wedge = wedges.facing(way);
    const double depth = wedges.depth(wedge, way);
    // A solution outside the ring but beyond the arc is in the hull of the arc's cells only.
    if (depth <= least) continue;
    const double weight = (depth - least) * std::sqrt(wedges.box().width() * wedges.box().height()) *
                          (1.0 + relaxation.conflicts(ring.ring));
    if (weight <= most) continue;
    most = weight;
    split = Split{k, wedge};
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

}  // namespace

Children children(Relaxation& relaxation, const Problem& problem, const Node& node, const BranchTuning& tuning,
                  double depth) {
  Children found;
  bool refuted = false;
  const double slack = tuning.slack / relaxation.columns().scale;
  const Reasons own = programs::decision(node.depth);
  const auto attempt = [&](const auto& restrict) {
    if (refuted) return;
    Node child = node;
    ++child.depth;
    child.program.drop_slack_rows(relaxation.columns(), slack);
    if (restrict(child) && relaxation.settle(child)) {
      found.nodes.push_back(std::move(child));
    } else if ((relaxation.conflict() & own) == 0) {
      refuted = true;
      found.conflict = relaxation.conflict();
    } else {
      found.conflict |= programs::without(relaxation.conflict(), node.depth);
    }
  };
  if (const auto body = undecided(problem, node)) {
    for (std::uint32_t variant = 0; variant < problem.bodies[*body].variants.size(); ++variant) {
      attempt([&](Node& child) { return relaxation.decide(child, *body, variant) && relaxation.limit_length(child); });
    }
  } else {
    const auto split = deepest(relaxation, problem, node, depth);
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
  std::stable_sort(found.nodes.begin(), found.nodes.end(),
                   [](const Node& a, const Node& b) { return a.program.cost() > b.program.cost(); });
  return found;
}

}  // namespace selvage::packing::branching
