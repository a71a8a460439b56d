// One move of the search: a piece goes to where it loses least, among all positions in all its orientations.
//
// The field of every orientation gives the places to look at, descents over the exact depths refine the best of them,
// and the place where the piece lies competes, too.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/nesting/fields/kept_fields.h"
#include "core/nesting/local_search/neighbourhood.h"

namespace selvage::nesting::local_search {

class Mover {
 public:
  // `field_bytes`: memory for the fields that are kept.  REQUIRES: all others outlive the mover.
  Mover(const layout::PieceSet& set, depth::DepthMaps& maps, Losses& losses, layout::Dice& dice,
        const SearchTuning& tuning, std::size_t field_bytes);

  // Moves the piece and measures its losses anew.
  void move(layout::Layout& layout, std::size_t piece);
  // Puts the piece where it ends leftmost without overlapping any of `others`, as far as the sampled maps can tell;
  // false when it fits nowhere, and the layout stays as it is.
  [[nodiscard]] bool insert(layout::Layout& layout, std::size_t piece, const std::vector<std::uint32_t>& others);

 private:
  using Candidate = fields::Candidate;

  // The positions that the piece may take from there without changing to another repeat of the cloth.
  [[nodiscard]] RealBox room_about(const layout::Layout& layout, std::size_t piece, const layout::Place& place) const;
  // The leftmost position that overlaps nothing, among those up to `last`; nothing when there is none.  The layout is
  // the same afterwards.
  [[nodiscard]] std::optional<layout::Place> leftmost_free(layout::Layout& layout, std::size_t piece,
                                                           std::uint32_t turn, double last);
  void collect(const layout::Layout& layout, std::size_t piece);
  // Whether a move looks at this orientation: where fields are expensive, always at the present one and at one other on
  // average.
  [[nodiscard]] bool looks_at(const layout::Layout& layout, std::size_t piece, std::uint32_t turn);
  void pick();
  [[nodiscard]] Candidate stay(const layout::Layout& layout, std::size_t piece);
  [[nodiscard]] Candidate refined(const layout::Layout& layout, std::size_t piece, const Candidate& candidate,
                                  double best);
  [[nodiscard]] Candidate finished(const layout::Layout& layout, std::size_t piece, const Candidate& candidate);
  // Descends over exact losses, with the edges that matter within `reach` of the place.
  [[nodiscard]] Candidate exact(const layout::Layout& layout, std::size_t piece, const layout::Place& from,
                                double reach, double step, double limit);

  const layout::PieceSet* set_;
  Losses* losses_;
  layout::Dice* dice_;
  SearchTuning tuning_;
  double pixel_;
  fields::KeptFields fields_;
  fields::Field strip_;  // of a piece that is inserted
  Neighbourhood neighbourhood_;
  std::vector<float> weights_;  // by piece, what an overlap with it counts
  std::vector<Candidate> candidates_, picked_;
};

}  // namespace selvage::nesting::local_search
