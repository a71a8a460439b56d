// One open part of the search: a stack of nodes, explored depth first.
#pragma once

#include <cstdint>
#include <stop_token>
#include <vector>

#include "core/packing/branching/relaxation.h"

namespace selvage::packing::branching {

// A solution of a leaf's program: a layout up to rounding.
struct Leaf {
  std::vector<RealVec> positions;      // of the bodies; lattice units
  std::vector<std::uint32_t> variant;  // of the bodies
  double length{};
};

class Subtree {
 public:
  // The subtree below one node.  The problem must outlive this.
  Subtree(const Problem& problem, const BranchTuning& tuning, Node node, double ceiling);

  // Explores at most so many nodes.  Where the length is minimised, a leaf lowers the ceiling to `gap` below its
  // length; otherwise the exploration stops at a leaf.
  void explore(std::uint64_t nodes, double gap, const std::stop_token& stop);
  void lower_ceiling(double ceiling);

  [[nodiscard]] bool done() const { return stack_.empty(); }
  // No layout in it is shorter; infinite when done.
  [[nodiscard]] double bound() const;
  // What was found since the last call.
  [[nodiscard]] std::vector<Leaf> take_leaves() { return std::move(leaves_); }
  // The work since the last call.
  [[nodiscard]] Work take_work();
  // Takes the open nodes apart: each becomes a subtree.
  [[nodiscard]] std::vector<Node> take_nodes() { return std::move(stack_); }
  [[nodiscard]] double ceiling() const { return relaxation_.ceiling(); }

 private:
  void record(const Node& node, double gap);

  const Problem* problem_;
  BranchTuning tuning_;
  Relaxation relaxation_;
  std::vector<Node> stack_;
  std::vector<Leaf> leaves_;
};

}  // namespace selvage::packing::branching
