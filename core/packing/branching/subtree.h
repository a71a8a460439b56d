// One open part of the search: a stack of nodes, explored depth first.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <stop_token>
#include <vector>

#include "core/packing/branching/relaxation.h"

namespace selvage::packing::branching {

// A solution of a leaf's program: first a layout up to rounding, then placed, which means on lattice points and proved
// valid.
struct Leaf {
  std::vector<RealVec> positions;      // of the bodies; lattice units
  std::vector<std::uint32_t> variant;  // of the bodies
  std::vector<Row> rows;               // the exact lines of the wedges that the solution lies in
  double length{};
};

// Moves the leaf's positions to lattice points at which its layout is valid, proved, and sets its length.  False when
// it finds none.  Called concurrently.
using PlaceLeaf = std::function<bool(Leaf&)>;

class Subtree {
 public:
  // The subtree below one node.  The problem must outlive this.
  Subtree(const Problem& problem, const BranchTuning& tuning, Node node, double ceiling);

  // Explores at most this many nodes.  Where the length is minimised, a placed leaf lowers the ceiling to `gap` below
  // its length; otherwise the exploration stops there.
  void explore(std::uint64_t nodes, double gap, const PlaceLeaf& place_leaf, const std::stop_token& stop);
  void lower_ceiling(double ceiling);
  [[nodiscard]] const Conflicts& conflicts() const { return relaxation_.all_conflicts(); }
  void learn(const Conflicts& conflicts) { relaxation_.learn(conflicts); }

  [[nodiscard]] bool done() const { return stack_.empty(); }
  [[nodiscard]] std::uint64_t explored() const { return explored_; }  // nodes so far
  // No layout that is still to be found in it is shorter; infinite when done.
  [[nodiscard]] double bound() const;
  // The least length of a leaf that was not placed, or became longer by more than the gap when it was placed; infinite
  // when there is none.  Layouts of about this length are neither found nor ruled out.
  [[nodiscard]] double undecided() const { return undecided_; }
  // The placed leaves since the last call.
  [[nodiscard]] std::vector<Leaf> take_leaves() { return std::move(leaves_); }
  // The work since the last call.
  [[nodiscard]] Work take_work();
  // Takes the open nodes apart: each becomes a subtree.
  [[nodiscard]] std::vector<Node> take_nodes() { return std::move(stack_); }
  [[nodiscard]] double ceiling() const { return relaxation_.ceiling(); }

 private:
  // True when a layout is found that ends the exploration.
  [[nodiscard]] bool expand(const Node& node, double gap, const PlaceLeaf& place_leaf);
  // The node taken last, which is at this depth, has no layout that is still of interest.  Nor has its parent when that
  // does not depend on the decision between the two, or when it was the last child; and so on upwards [Pro93].
  void close(std::size_t depth, Reasons conflict);
  [[nodiscard]] bool record(const Node& node, double gap, const PlaceLeaf& place_leaf);

  const Problem* problem_;
  BranchTuning tuning_;
  Relaxation relaxation_;
  std::vector<Node> stack_;
  std::vector<Reasons> conflicts_;  // of the nodes on the way to the next one: why their closed children are closed
  std::vector<Leaf> leaves_;
  std::uint64_t explored_{};
  double undecided_{std::numeric_limits<double>::infinity()};
};

}  // namespace selvage::packing::branching
