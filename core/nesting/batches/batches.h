// Nesting of more pieces than one search can handle: they are dealt into batches, each with pieces of all sizes, and
// one batch after another is nested to the right of those before.
//
// The pieces at the right end of what lies already take part in the next batch as locked ones, and the batch stays to
// the right of a line that no other piece crosses.  So batches reach into each other, the searches grow with the number
// of pieces, and what is valid with its neighbours is valid with all pieces.
// Units: lattice units.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "core/marker/marker.h"

namespace selvage::nesting::batches {

struct BatchTuning {
  std::size_t pieces{300};  // of a batch, at most
  std::size_t beside{80};   // earlier pieces that take part in it, about: the last ones,
  double reach{0.5};        // and only within this many widths of the right end
  friend bool operator==(const BatchTuning&, const BatchTuning&) = default;
};

// Places the unplaced pieces of a marker beside its locked ones: the answer lists the locked ones first, then the
// others, in order.  `left`: how many batches are not nested yet, this one among them.  Nothing when it cannot.
using NestBatch = std::function<std::optional<Marker>(const Marker& batch, std::size_t left)>;

// `all` has all pieces on a strip without an end; those that `stay` are valid, and the others are nested to the right
// of them.  Once `over` holds, all that are left make one batch.  Nothing when there are no others, when one of them
// has a rule about where along the strip it lies, or when a batch failed. REQUIRES: `stay` has an entry for each piece.
[[nodiscard]] std::optional<Marker> nested_in_batches(const Marker& all, const std::vector<bool>& stay,
                                                      const BatchTuning& tuning, const NestBatch& nest,
                                                      const std::function<bool()>& over);

}  // namespace selvage::nesting::batches
