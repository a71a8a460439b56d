// A layout that needs no search: pieces in columns, one column after another, each piece in a box of its own.  It is
// what nesting starts from, and what it answers when it is stopped at once.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/marker/marker.h"
#include "core/nesting/layout/piece_set.h"

namespace selvage::nesting::start {

// Places the pieces that are not `kept` to the right of those that are, and all unplaced pieces, on a strip without an
// end.  No box of theirs comes closer to another than the clearances ask for, so they collide with nothing.  They keep
// their selvedges, the beginnings of their bands and the fold; the ends of bands and shades only where that happens to
// be possible (first_layout.h).
// REQUIRES: the set is that of `start`, `kept` has an entry for each of its placed pieces, and fixed ones are kept.
// Errors: kBeyondLattice when the layout would be too long for the lattice.
[[nodiscard]] Result<Marker> on_shelves(const Marker& start, const layout::PieceSet& set,
                                        const std::vector<bool>& kept);

}  // namespace selvage::nesting::start
