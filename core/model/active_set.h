// The active set: the pieces that a program has columns for.  These are the pieces that the goal moves, and those that
// they press on.  All other pieces stay where they are, as obstacles.
//
// Where every displacement has a cost, an inactive piece matters only when rows press on it harder than moving it
// costs: this is the pricing test by which columns enter in the simplex method.  When no piece passes it, the program's
// optimum is also that of the program with columns for all pieces, because two pieces that stay break no row between
// them. Invariant: of pieces that are tied together, all are active or none; fixed pieces never are.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/marker/placed_pieces.h"
#include "core/model/position_model.h"
#include "core/model/ties.h"

namespace selvage::model {

// What a program models.
enum class Extent {
  kActiveSet,  // the active pieces, the rows that can be broken, and the pairs that come near each other
  kWhole,      // every piece, pair and row of the marker at once: the same answer, for comparison
};

class ActiveSet {
 public:
  // The factor by which the set grows at each step: the programs of a growing set together then cost little more
  // than the last of them.
  static constexpr std::size_t kGrowth = 8;

  // Empty.
  explicit ActiveSet(Ties ties, std::size_t growth = kGrowth);

  // Adds the piece and all that is tied to it.
  void add(std::size_t piece);
  void add_all();
  // Adds the missed pieces, and rings of neighbours around them until the set is `growth` times as large as before.
  void grow(std::vector<std::uint32_t> missed, std::span<const marker::PiecePair> neighbours);
  // Ties the two together: from now on they move as one.
  void join(std::size_t p, std::size_t q);

  [[nodiscard]] bool holds(std::size_t piece) const { return active_[piece] != 0; }
  // True for a piece that is neither active nor fixed.
  [[nodiscard]] bool may_hold(std::size_t piece) const { return !holds(piece) && !ties_.fixed(piece); }
  [[nodiscard]] bool holds_any(marker::PiecePair pair) const { return holds(pair.first) || holds(pair.second); }
  // True when every piece that is not fixed is active.
  [[nodiscard]] bool complete() const { return left_ == 0; }
  [[nodiscard]] const Ties& ties() const { return ties_; }
  // The ties of the program: inactive pieces are fixed.
  [[nodiscard]] Ties with_others_fixed() const;

  // The inactive pieces that would move if they had columns: `load` is the force of the rows on each piece (gain per
  // unit of displacement), a unit of motion costs `price` on either axis, and no piece may leave its room on a strip
  // that ends at x = `end`.
  [[nodiscard]] std::vector<std::uint32_t> missed(const marker::PlacedPieces& pieces, const std::vector<RealVec>& load,
                                                  double price, const Strip& strip, Coord end) const;

 private:
  Ties ties_;
  std::size_t growth_;
  std::vector<char> active_;
  std::size_t count_{};  // active
  std::size_t left_{};   // neither fixed nor active
};

// The forces that rows exert on their pieces: the sums of their dual values along their normals.
class Pressure {
 public:
  explicit Pressure(std::size_t pieces) : load_(pieces) {}
  void add(const PairRow& row, double dual);
  // The rows of the model's shades.
  void add_shades(const PositionModel& model, std::span<const double> dual);
  [[nodiscard]] const std::vector<RealVec>& load() const { return load_; }

 private:
  std::vector<RealVec> load_;
};

}  // namespace selvage::model
