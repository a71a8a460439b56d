// The field of a piece: what it would lose at every position of the strip, in one orientation, from the sampled depth
// maps of all other pieces.  Its lowest places are where a move may take the piece.
//
// That the whole strip is searched, and not a sample of positions, follows [UYI+09] and [Egeblad07] in spirit; they
// search along lines, exactly.
//
// Between two moves of a piece most others stay where they are.  So a field that is computed again in the same room
// subtracts what the others that have moved added before, and adds what they add now.  This leaves no rounding errors
// behind: weights are rounded to whole multiples of a unit that is chosen so that all sums of weighted samples are
// whole numbers that a float holds exactly.
// Units: model units, but for the cells.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/depth/grid_block.h"
#include "core/nesting/fields/cells.h"
#include "core/nesting/layout/dice.h"
#include "core/nesting/layout/layout.h"

namespace selvage::nesting::fields {

struct Candidate {
  float loss{};
  layout::Place place;
};

class Field {
 public:
  // REQUIRES: both outlive the field.
  Field(const layout::PieceSet& set, depth::DepthMaps& maps) : set_{&set}, maps_{&maps} {}

  // Computes the field of the piece in an orientation, no farther along the strip than `reach` from where it lies, and
  // at least three fifths as far.  `weights`: by piece, what an overlap with it counts; 0 leaves it out.  False, and
  // nothing is computed, when the piece fits nowhere.
  [[nodiscard]] bool compute(const layout::Layout& layout, std::size_t piece, std::uint32_t turn,
                             std::span<const float> weights, double reach = std::numeric_limits<double>::infinity());

  // Appends the lowest position of each of the `rows` lowest rows.
  void append_lowest(std::size_t rows, layout::Dice& dice, std::vector<Candidate>& candidates) const;
  // The leftmost position without any loss, and among those the lowest; nothing when there is none.
  [[nodiscard]] std::optional<layout::Place> leftmost_free() const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  // What a piece adds to the cells.
  struct Counted {
    layout::Place place;
    float weight{};
    float most{};  // to a cell, at most; 0 for a piece that the field does not reach
  };
  // A piece whose overlaps count `now` instead of `before`.
  struct Change {
    depth::MapView view;
    double x{}, y{};  // position of the other piece
    float before{}, now{};
  };

  [[nodiscard]] RealBox room_within(const layout::Layout& layout, std::size_t piece, std::uint32_t turn,
                                    double reach) const;
  void clear();
  // Notes what the pieces count; returns how this differs from what the cells hold.
  [[nodiscard]] std::vector<Change> find_changes(const layout::Layout& layout, std::span<const float> weights);
  void find_change(std::uint32_t other, const layout::Place& at, float weight, std::vector<Change>& changes);
  // Whether the piece can overlap another one, or come too near to it, at some position of the field.
  [[nodiscard]] bool reaches(const layout::Turned& theirs, const layout::Place& at) const;
  // The largest sum that a cell could hold, in model units.
  [[nodiscard]] double most_in_a_cell() const;
  // Whether all sums are whole numbers that a float holds, and no coarser than they need to be.
  [[nodiscard]] bool unit_suits() const;
  void choose_unit();
  void add(const std::vector<Change>& changes);
  [[nodiscard]] float in_units(float weight, float sample) const;
  void append_block(const Change& change, std::vector<depth::GridBlock>& blocks);
  [[nodiscard]] layout::Place place_at(Cell cell) const;
  // Rules out the cells in which no position is matched to the cloth.
  void leave_out_unmatched();

  const layout::PieceSet* set_;
  depth::DepthMaps* maps_;
  RealBox room_;  // the positions
  std::size_t piece_{};
  std::uint32_t turn_{};
  Cells cells_;                   // in units
  float unit_{1};                 // a power of two
  std::vector<Counted> counted_;  // by piece, what the cells hold; empty when they are of no further use
};

}  // namespace selvage::nesting::fields
