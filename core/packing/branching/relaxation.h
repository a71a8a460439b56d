// The work at a node: trimming arcs, propagating boxes and solving the linear relaxation.
//
// A look at a ring clips its arc's cells by the pair's box.  Cells at the arc's ends that are empty are cut off; the
// box of all cells bounds the pair's difference, and through shortest paths those of other pairs; the hull of all cells
// gives rows to the program, made when a solution violates them.  Looks repeat while boxes shrink (Daniels and
// Milenkovic's "restrict" [DM97]).
// Every fact is kept with its reasons, the decisions from which it was concluded (programs/reasons.h).  So a conflict
// names decisions that have no layout in common, and the search leaves out all other nodes below these decisions.
// Everything that is concluded holds for all valid layouts on the lattice: cells contain what they stand for
// (wedge_ring.h), differences of lattice points are whole, and what the program claims is proved (leaf_proof.h).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/packing/branching/node.h"
#include "core/packing/branching/tuning.h"
#include "core/packing/programs/leaf_proof.h"

namespace selvage::packing::branching {

using cells::Cell;
using cells::HalfPlane;
using programs::Columns;
using programs::Ranges;
using programs::Row;

// What a search has done so far, in units that do not depend on the machine.
struct Work {
  std::uint64_t nodes{}, pivots{}, looks{};
  std::uint64_t skipped{};   // open nodes that were closed by a conflict which does not depend on what sets them apart
  std::uint64_t unproved{};  // claims of the linear program that could not be proved, and so were not used
  Work& operator+=(const Work& other);
};

// How often looks have found that no layout is left.
struct Conflicts {
  std::vector<std::uint32_t> of_rings;  // by ring of the problem
  std::vector<std::uint32_t> of_pairs;  // by pair of bodies, the world included

  explicit Conflicts(const Problem& problem)
      : of_rings(problem.rings.size()), of_pairs((problem.bodies.size() + 1) * (problem.bodies.size() + 1)) {}
  // Adds those by which `now` exceeds `before`.
  void add_since(const Conflicts& before, const Conflicts& now);
};

// The columns of a problem's programs: the least positions, and a scale at which the room is about 1 wide.
[[nodiscard]] Columns columns_of(const Problem& problem);

class Relaxation {
 public:
  // The problem must outlive this.
  Relaxation(const Problem& problem, const BranchTuning& tuning);

  // The node of all layouts not longer than the ceiling; nothing when there are none.
  [[nodiscard]] std::optional<Node> root(double ceiling);
  // The same for those in a vicinity.
  [[nodiscard]] std::optional<Node> root_in(const Vicinity& vicinity, double ceiling);
  // The ways to go on.  False when no layout is left.
  [[nodiscard]] bool decide(Node& node, std::uint32_t body, std::uint32_t variant);
  [[nodiscard]] bool keep_arc(Node& node, std::size_t ring, Arc arc);
  [[nodiscard]] bool limit_length(Node& node);
  // Propagates and solves.  Afterwards the program's solution satisfies all rows.
  [[nodiscard]] bool settle(Node& node);

  // After one of these has found that no layout is left: the decisions from which that follows.
  [[nodiscard]] Reasons conflict() const { return conflict_; }
  // How often a look at the ring has found that no layout is left, plus a part of how often looks at the other rings of
  // the two bodies have, those in other orientations included.
  [[nodiscard]] double conflicts(const RingState& ring) const;
  [[nodiscard]] const Conflicts& all_conflicts() const { return conflicts_; }
  void learn(const Conflicts& conflicts) { conflicts_ = conflicts; }
  // Decisions count from this node on: what is known at it holds unconditionally.
  void begin_at(Node& node);

  // Layouts longer than this do not count any more.
  void lower_ceiling(double ceiling) { ceiling_ = ceiling; }
  [[nodiscard]] double ceiling() const { return ceiling_; }
  [[nodiscard]] RealVec position(const Node& node, std::uint32_t body) const;
  [[nodiscard]] RealVec difference(const Node& node, const RingState& ring) const;
  // For every ring, the exact line of the wedge that the solution lies in.
  [[nodiscard]] std::vector<Row> exact_rows(const Node& node) const;
  [[nodiscard]] const Columns& columns() const { return columns_; }
  // The depth at which a solution counts as inside a ring; lattice units.
  [[nodiscard]] double tolerance() const { return tuning_.tolerance / columns_.scale; }

  // A copy of the node, in the memory of one that was given back.
  [[nodiscard]] Node copy(const Node& node);
  void give_back(Node node);

  [[nodiscard]] std::size_t hulls() const { return hulls_.size(); }
  void forget_hulls_from(std::size_t size) { hulls_.resize(size); }
  [[nodiscard]] const Work& work() const { return work_; }
  [[nodiscard]] Work& work() { return work_; }

 private:
  [[nodiscard]] std::optional<Node> undecided_root(double ceiling);
  [[nodiscard]] double least_width(const Node& node, std::uint32_t body) const;
  void start_program(Node& node);
  [[nodiscard]] RealBox pair_box(const Node& node, const RingState& ring) const;
  [[nodiscard]] bool raise(DifferenceBounds& bounds, std::size_t a, std::size_t b, double bound, Reasons why);
  [[nodiscard]] bool raise_to(Node& node, const RingState& ring, const RealBox& box, Reasons why);
  [[nodiscard]] std::size_t pair_of(const RingState& ring) const {
    return ring.first * positions_.size() + ring.second;
  }
  [[nodiscard]] static Reasons why_pair_box(const Node& node, const RingState& ring);
  [[nodiscard]] bool activate_pair(Node& node, const Chosen& first, const Chosen& second);
  [[nodiscard]] bool order_alike(Node& node, std::uint32_t body);
  [[nodiscard]] static std::optional<RealBox> trim(const WedgeRing& wedges, Arc& arc, const RealBox& box);
  [[nodiscard]] bool look(Node& node, RingState& ring);
  [[nodiscard]] bool stays_free(Node& node);
  [[nodiscard]] bool propagate(Node& node);
  [[nodiscard]] static const lines::Chords& chords_in(const Node& node, const Lines& lines, std::uint32_t body) {
    const std::uint32_t variant = node.variant[body];
    return variant == Node::kUndecided ? lines.chords[body].back() : lines.chords[body][variant];
  }
  [[nodiscard]] bool sum_chords(const Node& node, const Lines& lines, const DifferenceBounds& bounds);
  [[nodiscard]] Reasons why_covered(const Node& node, const DifferenceBounds& bounds, std::size_t line,
                                    std::uint32_t besides, double spare) const;
  [[nodiscard]] bool keep_beside_line(const Node& node, const Lines& lines, DifferenceBounds& bounds, std::size_t line,
                                      std::uint32_t body, double room);
  [[nodiscard]] bool fit_on(Node& node, const Lines& lines, DifferenceBounds& bounds);
  [[nodiscard]] bool fit_on_lines(Node& node);
  void gather(const RingState& ring, const RealBox& box);
  void make_hull(const Node& node, RingState& ring);
  [[nodiscard]] bool add_violated_rows(Node& node);
  [[nodiscard]] bool violates_bounds(const Node& node, std::uint32_t a, double least) const;
  [[nodiscard]] bool add_violated_bounds(Node& node);
  [[nodiscard]] bool add_violated_hull(Node& node, RingState& ring);
  [[nodiscard]] const Ranges& ranges(const Node& node);
  [[nodiscard]] bool is_refuted(const Node& node);
  [[nodiscard]] bool is_too_long(const Node& node);
  void raise_bound(Node& node);

  const Problem* problem_;
  BranchTuning tuning_;
  Columns columns_;
  double ceiling_{};
  Reasons conflict_{};
  std::vector<RealBox> wide_;  // where the bodies can be, unconditionally; none before the first node
  std::vector<HalfPlane> hulls_;
  std::vector<RealVec> points_;     // of the cells last gathered
  std::vector<HalfPlane> chords_;   // of the box in which they lie
  std::vector<RealVec> positions_;  // of the bodies and the world, at the solution
  struct ChordSums {
    std::vector<double> own;   // by line and body
    std::vector<double> sums;  // by line
  };
  ChordSums on_lines_;  // of the node and the lines last looked at
  Conflicts conflicts_;
  std::vector<Node> spare_;  // nodes that were given back
  Ranges ranges_;            // of the node that something was last proved about
  Work work_;
};

}  // namespace selvage::packing::branching
