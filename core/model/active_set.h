// The pieces a program has columns for: those that something moves, and those that these press upon.  All others stay,
// and are only in the way.
//
// Where every motion has its price, a piece that stays is missed only when rows press on it harder than moving it
// costs: the test by which columns enter in the simplex method.  When none is missed, the program's optimum is also
// that of the program with columns for all pieces, for staying breaks no row between two that stay. Invariant: of tied
// pieces, all are reached or none; what is fixed never is.
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
  kReached,  // what can be reached: the pieces above, rows that can be broken, pairs that come near each other
  kWhole,    // every piece, pair and row of the marker, at once: the same answer, for measuring against
};

class ActiveSet {
 public:
  // None.
  explicit ActiveSet(Ties ties);

  // The piece, and all that is tied to it.
  void add(std::size_t piece);
  void add_all();
  // Those that were missed, and rings of neighbours about them until there are several times as many as before: the
  // programs of a growing set then cost little more than the last of them.
  void grow(std::vector<std::uint32_t> missed, std::span<const marker::PiecePair> neighbours);
  // From now on the two move as one.
  void join(std::size_t p, std::size_t q);

  [[nodiscard]] bool holds(std::size_t piece) const { return reached_[piece] != 0; }
  // Neither reached nor fixed.
  [[nodiscard]] bool may_hold(std::size_t piece) const { return !holds(piece) && !ties_.fixed(piece); }
  [[nodiscard]] bool holds_any(marker::PiecePair pair) const { return holds(pair.first) || holds(pair.second); }
  // Every piece that is not fixed.
  [[nodiscard]] bool complete() const { return left_ == 0; }
  [[nodiscard]] const Ties& ties() const { return ties_; }
  // The ties of the program: what is not reached is fixed.
  [[nodiscard]] Ties with_others_fixed() const;

  // Those that are missed, when `load` presses on each piece (per unit of displacement), a unit of motion costs `price`
  // on either axis, and no piece may leave `room`.
  [[nodiscard]] std::vector<std::uint32_t> missed(const marker::PlacedPieces& pieces, const std::vector<RealVec>& load,
                                                  double price, const Box& room) const;

 private:
  Ties ties_;
  std::vector<char> reached_;
  std::size_t count_{};  // reached
  std::size_t left_{};   // neither fixed nor reached
};

// How hard rows press on the pieces of their pairs.
class Pressure {
 public:
  explicit Pressure(std::size_t pieces) : load_(pieces) {}
  void add(const PairRow& row, double dual);
  [[nodiscard]] const std::vector<RealVec>& load() const { return load_; }

 private:
  std::vector<RealVec> load_;
};

}  // namespace selvage::model
