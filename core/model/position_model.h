// The position model: all pieces' displacements as one linear program [Li94 4.1.3, 4.1.4].
//
// Columns are displacements from the present positions, in model units (model_unit.h).  On each axis, tied pieces share
// a column and fixed pieces have none (ties.h).  Rows are n . (d_q - d_p) >= bound with unit normals n (pair_rows.h).
// The change of the marker's length may be one more column.
// Cloth's rules are modelled here, once for every program: the room of a piece is the bounds of its columns, and each
// shade is one column, the left end of the cloth that its pieces have to lie on, with two rows for each of them.  A
// match set is a tie: its repeats are fixed.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/real_plane.h"
#include "core/lp/linear_program.h"
#include "core/marker/placed_pieces.h"
#include "core/model/model_unit.h"
#include "core/model/pair_rows.h"
#include "core/model/ties.h"

namespace selvage::model {

// The entries of a pair's row: at most two columns of each piece, and one more.
struct Terms {
  std::array<lp::LinearProgram::Entry, 5> entries{};
  std::size_t count{};
  void add(int column, double value) { entries[count++] = {column, value}; }
  [[nodiscard]] std::span<const lp::LinearProgram::Entry> all() const { return std::span{entries}.first(count); }
};

// A row that keeps a piece inside the cloth of its shade: nx . displacement - nx . (motion of that cloth) >= bound.
struct ShadeRow {
  std::uint32_t piece{};
  double nx{};
  int in_program{};
};

class PositionModel {
 public:
  // The pieces' rooms become bounds of the columns [Li94 4.1.3]; a piece that is outside its room now has to come back,
  // and so have pieces of a shade that are too far from each other.  The pieces of a match set move as one where the
  // pattern repeats.
  PositionModel(const marker::PlacedPieces& pieces, const Strip& strip, const Ties& ties);

  [[nodiscard]] ModelUnit unit() const { return unit_; }

  // No useful displacement is larger than this, in columns: several times the marker's length and width.
  [[nodiscard]] double reach() const;
  // Returns the program's row, or nothing when the two never move against each other and no row is needed.  With a
  // column `give`, the row may be broken by that column's value.
  std::optional<int> add(const PairRow& row, std::optional<int> give = {});
  // The length column, at `cost` per unit, from -`shorten` to `lengthen` lattice units.
  void add_length(double cost, double shorten, double lengthen);
  // Keeps piece i left of the strip's present length plus the length column.  REQUIRES: add_length.
  void add_right_wall(std::size_t piece);
  [[nodiscard]] bool has_right_wall(std::size_t piece) const { return wall_row_[piece] != kNoWall; }
  // The row of a piece's right wall, if it has one (a fixed piece bounds the length column instead).
  [[nodiscard]] std::optional<int> right_wall_row(std::size_t piece) const;
  // The rows of shades; none for a shade all of whose pieces are fixed.
  [[nodiscard]] std::span<const ShadeRow> shade_rows() const { return shade_rows_; }
  // Costs per unit of a piece's displacement.
  void add_cost(std::size_t piece, double x, double y);
  // Costs per unit of |x| and |y| of every displacement: one column and two rows for each.  With `home`, one position
  // per piece, the cost is that of each piece's distance from its home; of tied pieces only the first counts.
  void add_displacement_penalty(double cost, std::span<const Vec> home = {});

  [[nodiscard]] const lp::LinearProgram& program() const { return program_; }
  [[nodiscard]] lp::LinearProgram& program() { return program_; }
  // A piece's columns, or nothing where it is fixed.
  [[nodiscard]] std::optional<int> x_column(std::size_t piece) const { return some(x_[piece]); }
  [[nodiscard]] std::optional<int> y_column(std::size_t piece) const { return some(y_[piece]); }
  // (nx, ny) . (displacement of q - displacement of p) as a row's entries; without p, the displacement of q alone.
  [[nodiscard]] Terms terms(std::size_t q, std::optional<std::size_t> p, double nx, double ny) const;
  [[nodiscard]] std::vector<RealVec> displacements(std::span<const double> x) const;
  [[nodiscard]] double length_change(std::span<const double> x) const;  // lattice units

 private:
  static constexpr int kNone = -1;
  [[nodiscard]] static std::optional<int> some(int column) {
    return column == kNone ? std::nullopt : std::optional{column};
  }
  void bound(int& column, double low, double high);
  void add_shade(const marker::Shade& shade);

  const marker::PlacedPieces& pieces_;
  ModelUnit unit_;
  Coord length_;
  std::vector<int> x_, y_;  // each piece's columns; kNone where it is fixed
  static constexpr int kNoWall = -2;
  static constexpr int kWallIsBound = -1;
  std::vector<int> wall_row_;  // of each piece, or one of the two above
  int length_column_{-1};
  std::vector<ShadeRow> shade_rows_;
  lp::LinearProgram program_;
};

}  // namespace selvage::model
