#include "core/packing/branching/subtree.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/packing/branching/branch.h"

namespace selvage::packing::branching {

Subtree::Subtree(const Problem& problem, const BranchTuning& tuning, Node node, double ceiling)
    : problem_{&problem}, tuning_{tuning}, relaxation_{problem, tuning} {
  for (RingState& ring : node.rings) ring.hull_begin = RingState::kNone;
  node.hulls = 0;
  relaxation_.lower_ceiling(ceiling);
  stack_.push_back(std::move(node));
}

void Subtree::lower_ceiling(double ceiling) {
  relaxation_.lower_ceiling(std::min(ceiling, relaxation_.ceiling()));
}

void Subtree::explore(std::uint64_t nodes, double gap, const PlaceLeaf& place_leaf, const std::stop_token& stop) {
  for (std::uint64_t count = 0; count < nodes && !stack_.empty() && !stop.stop_requested(); ++count) {
    Node node = std::move(stack_.back());
    stack_.pop_back();
    if (node.bound > relaxation_.ceiling() || !relaxation_.limit_length(node)) continue;
    ++relaxation_.work().nodes;
    relaxation_.forget_hulls_from(node.hulls);
    auto below = children(relaxation_, *problem_, node, tuning_, relaxation_.tolerance());
    if (!below) {
      const bool placed_leaf = record(node, gap, place_leaf);
      if (placed_leaf && !problem_->minimises_length) return;
      if (placed_leaf) continue;
      // Rounding may have chosen the wrong one of two wedges that meet near the solution.
      below = children(relaxation_, *problem_, node, tuning_, -tuning_.contact);
      if (!below) undecided_ = std::min(undecided_, node.bound);
      if (!below) continue;
    }
    for (Node& child : *below) {
      child.hulls = relaxation_.hulls();
      stack_.push_back(std::move(child));
    }
  }
}

bool Subtree::record(const Node& node, double gap, const PlaceLeaf& place_leaf) {
  Leaf leaf{.positions = {}, .variant = node.variant, .rows = relaxation_.exact_rows(node), .length = node.bound};
  for (std::uint32_t body = 0; body < problem_->world(); ++body) {
    leaf.positions.push_back(relaxation_.position(node, body));
  }
  if (!place_leaf(leaf)) return false;
  if (problem_->minimises_length) {
    if (leaf.length > node.bound + gap) undecided_ = std::min(undecided_, node.bound);
    lower_ceiling(leaf.length - gap);
  }
  leaves_.push_back(std::move(leaf));
  return true;
}

double Subtree::bound() const {
  double least = std::numeric_limits<double>::infinity();
  for (const Node& node : stack_) least = std::min(least, node.bound);
  return least;
}

Work Subtree::take_work() {
  return std::exchange(relaxation_.work(), {});
}

}  // namespace selvage::packing::branching
