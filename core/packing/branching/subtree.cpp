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
  relaxation_.begin_at(node);
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
    if (node.bound > relaxation_.ceiling()) {
      close(node.depth, node.why_bound);
    } else if (!relaxation_.limit_length(node)) {
      close(node.depth, relaxation_.conflict());
    } else if (expand(node, gap, place_leaf)) {
      return;
    }
    relaxation_.give_back(std::move(node));
  }
}

bool Subtree::expand(const Node& node, double gap, const PlaceLeaf& place_leaf) {
  ++relaxation_.work().nodes;
  ++explored_;
  relaxation_.forget_hulls_from(node.hulls);
  Children below = children(relaxation_, *problem_, node, tuning_, relaxation_.tolerance());
  if (below.leaf) {
    const bool placed_leaf = record(node, gap, place_leaf);
    if (placed_leaf && !problem_->minimises_length) return true;
    // Rounding may have chosen the wrong one of two wedges that meet near the solution.
    if (!placed_leaf) below = children(relaxation_, *problem_, node, tuning_, -tuning_.contact);
    if (below.leaf && !placed_leaf) undecided_ = std::min(undecided_, node.bound);
    if (below.leaf) below.conflict = programs::kAllDecisions;
  }
  if (below.nodes.empty()) {
    close(node.depth, below.conflict);
    return false;
  }
  conflicts_.resize(node.depth + 1);
  conflicts_[node.depth] = below.conflict;
  for (Node& child : below.nodes) {
    child.hulls = relaxation_.hulls();
    stack_.push_back(std::move(child));
  }
  return false;
}

void Subtree::close(std::size_t depth, Reasons conflict) {
  for (; depth > 0; --depth) {
    const std::size_t decided = depth - 1;
    const auto has_sibling = [&] { return !stack_.empty() && stack_.back().depth == depth; };
    if ((conflict & programs::decision(decided)) == 0) {
      for (; has_sibling(); stack_.pop_back()) ++relaxation_.work().skipped;
    } else {
      conflicts_[decided] |= programs::without(conflict, decided);
      if (has_sibling()) return;
      conflict = conflicts_[decided];
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
