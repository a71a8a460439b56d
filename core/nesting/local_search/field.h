// The field of a piece: what it would lose at every position of the strip, in one orientation, from the sampled depth
// maps of all other pieces.  Its lowest places are where a move may take the piece.
//
// That the whole strip is searched, and not a sample of positions, follows [UYI+09] and [Egeblad07] in spirit; they
// search along lines, exactly.
// Units: model units.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/nesting/depth/depth_maps.h"
#include "core/nesting/depth/grid_block.h"
#include "core/nesting/layout/dice.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/local_search/losses.h"

namespace selvage::nesting::local_search {

struct Candidate {
  float loss{};
  layout::Place place;
};

// Which pieces count, and how much.
enum class FieldWeights { kGuided, kEqual };

class Field {
 public:
  // REQUIRES: all of them outlive the field.
  Field(const layout::PieceSet& set, depth::DepthMaps& maps) : set_{&set}, maps_{&maps} {}

  // Computes the field of the piece in an orientation, against the pieces `others`, no farther along the strip than
  // `reach` from where it lies.  False, and nothing is computed, when the piece fits nowhere.
  [[nodiscard]] bool compute(const layout::Layout& layout, std::size_t piece, std::uint32_t turn,
                             const std::vector<std::uint32_t>& others, const Losses& losses, FieldWeights weights,
                             double reach = std::numeric_limits<double>::infinity());

  // Appends the lowest position of each of the `rows` lowest rows.
  void append_lowest(std::size_t rows, layout::Dice& dice, std::vector<Candidate>& candidates) const;
  // The leftmost position without any loss, and among those the lowest; nothing when there is none.
  [[nodiscard]] std::optional<layout::Place> leftmost_free() const;

 private:
  // Whether the piece can overlap another one, or come too near to it, at some position of the field.
  [[nodiscard]] bool reaches(const layout::Turned& own, const layout::Turned& theirs, const layout::Place& at) const;
  // How the depth map of the piece and another one is read.
  struct Reading {
    depth::MapView view;
    double x{}, y{};  // position of the other piece
    float weight{};
  };
  void find_readings(const layout::Layout& layout, std::size_t piece, const std::vector<std::uint32_t>& others,
                     const Losses& losses, FieldWeights weights);
  void append_block(const Reading& reading);
  [[nodiscard]] layout::Place place_at(std::size_t column, std::size_t row) const;
  // Rules out the cells in which no position is matched to the cloth.
  void leave_out_unmatched();

  const layout::PieceSet* set_;
  depth::DepthMaps* maps_;
  layout::RealBox room_;  // the positions
  std::size_t piece_{};
  std::uint32_t turn_{};
  std::size_t columns_{}, rows_{};
  std::vector<float> values_;             // row after row, and kLanes more at the end
  std::vector<Reading> readings_;         // of all pieces that the field reaches,
  std::vector<depth::GridBlock> blocks_;  // and what they add to it; both reused from one field to the next
};

}  // namespace selvage::nesting::local_search
