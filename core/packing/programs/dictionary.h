// A small linear program as a dense dictionary for the dual simplex method: the linear relaxation of one node of a
// search.  It is copied from a node to its children, so every program starts from an optimal basis of its parent.
//
// The columns are those of a packing: x and y of every body, and the marker's length, each as its distance from its
// least value, in units of `1 / scale` lattice units.  The program minimises the length or, where there is none to
// minimise, a small generic cost of all columns that makes optima unique.
// Numbers are floating-point.  What the dictionary claims counts only after it is proved (leaf_proof.h), from the
// multipliers of the rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/geometry/real_plane.h"
#include "core/packing/cells/wedge_ring.h"
#include "core/packing/programs/reasons.h"

namespace selvage::packing::programs {

using cells::HalfPlane;

// The row  plane.n . (position of `second` - position of `first`) >= plane.c, in lattice units.  The body `world` stays
// at the origin.  Where `length` is set: the length - plane.nx * (x of `second`) >= plane.c.
struct Row {
  std::uint32_t first{}, second{};
  bool length{};
  HalfPlane plane;
  Reasons why{};  // the decisions that the row follows from
};

// The bodies' positions and the length, in lattice units.
struct Columns {
  std::size_t bodies{};
  std::vector<RealVec> low;  // the least positions
  double low_length{};
  double scale{1};

  [[nodiscard]] std::size_t x(std::size_t body) const { return 2 * body; }
  [[nodiscard]] std::size_t y(std::size_t body) const { return 2 * body + 1; }
  [[nodiscard]] std::size_t length() const { return 2 * bodies; }
  [[nodiscard]] std::size_t count() const { return 2 * bodies + 1; }
};

class Dictionary {
 public:
  static constexpr double kUsualTolerance = 1e-9;

  enum class End { kOptimal, kInfeasible, kAboveCeiling, kTrouble };
  // A row with its multiplier in a proof; multipliers are positive.
  struct Multiplier {
    Row row;
    double value{};
  };

  // Begins without rows.  With `minimises_length` the cost is the length, with a trace of the other columns.
  Dictionary(const Columns& columns, bool minimises_length);

  void add(const Columns& columns, const Row& row);
  // Pivots until optimal, infeasible, or the length exceeds the ceiling; counts the pivots.
  // A row may be violated by the tolerance, in units of the columns.
  [[nodiscard]] End solve(const Columns& columns, double ceiling, std::uint64_t& pivots,
                          double tolerance = kUsualTolerance);
  // Drops the rows with more room than `room`, in lattice units, but keeps those of the length.
  void drop_slack_rows(const Columns& columns, double room);
  // Makes all rows hold unconditionally.
  void forget_why();

  [[nodiscard]] RealVec position(const Columns& columns, std::size_t body) const {
    return {columns.low[body].x + value(columns.x(body)) / columns.scale,
            columns.low[body].y + value(columns.y(body)) / columns.scale};
  }
  [[nodiscard]] double length(const Columns& columns) const {
    return columns.low_length + value(columns.length()) / columns.scale;
  }
  // The cost of the present solution, for comparing nodes.
  [[nodiscard]] double cost() const { return cost_[columns_]; }
  // The multipliers that bound the length from below, and those that prove infeasibility after kInfeasible.
  [[nodiscard]] std::vector<Multiplier> bounding() const;
  [[nodiscard]] std::vector<Multiplier> refuting() const;

 private:
  // A variable: the column of the program or, when there is none, the slack of `row`.
  struct Variable {
    std::int32_t column{-1};  // -1: a slack
    Row row{};
  };
  [[nodiscard]] double* row(std::size_t k) { return entries_.data() + k * stride_; }
  [[nodiscard]] const double* row(std::size_t k) const { return entries_.data() + k * stride_; }
  [[nodiscard]] double value(std::size_t column) const {
    const std::int32_t at = where_[column];
    return at >= 0 ? 0.0 : row(row_at(at))[columns_];
  }
  // The row that a negative place stands for.
  [[nodiscard]] static std::size_t row_at(std::int32_t place) {
    const std::int32_t row = ~place;
    return static_cast<std::size_t>(row);
  }
  void add_term(double* into, std::size_t column, double factor);
  void pivot(std::size_t leaving, std::size_t entering);
  [[nodiscard]] std::size_t most_violated(double tolerance) const;
  [[nodiscard]] std::size_t entering_for(std::size_t leaving) const;
  void note_place(const Variable& variable, std::int32_t at) {
    if (variable.column >= 0) where_[static_cast<std::size_t>(variable.column)] = at;
  }

  std::size_t columns_, stride_;
  std::vector<double> entries_;         // of the basic variables: row by row, the constant last
  std::vector<double> cost_;            // reduced costs, the constant last
  std::vector<Variable> free_, basic_;  // by column; by row
  std::vector<std::int32_t> where_;     // by column of the program: its place among the free, or ~ its row
  std::size_t refuted_{};               // the row that cannot be satisfied, after kInfeasible
};

}  // namespace selvage::packing::programs
