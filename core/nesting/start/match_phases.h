// Match sets while their pieces are laid out: searches that move one piece at a time match every piece of a set to the
// cloth instead, at a phase that is the same for the whole set.  So the set keeps its rule whichever piece moves.  That
// loses the freedom of the set to lie at any phase; a later compaction has it again.
#pragma once

#include <optional>

#include "core/marker/marker.h"

namespace selvage::nesting::start {

// The marker with pieces of match sets matched to the cloth: at the phase of the set's first placed piece, locked ones
// first; when none is placed, at a phase at which the piece with the least room across lies at the lower end of its
// room.  Nothing when there are no such pieces.
[[nodiscard]] std::optional<Marker> with_sets_matched_to_cloth(const Marker& marker);

// Gives the pieces of a marker back the rules that they have in another one, by id.  Those that it does not have, such
// as the zones of a sheet, keep their rules.
void give_back_rules(Marker& marker, const Marker& original);

}  // namespace selvage::nesting::start
