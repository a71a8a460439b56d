// Reads a cut file as a marker, in which the pieces lie where they are cut.
//
// The unit is the caller's, otherwise a tenth of a millimetre (G71), otherwise a hundredth of an inch.  A piece is the
// largest closed loop between two N; the knife cuts an outline in several runs, which are joined where their ends meet.
// Other loops and runs of the knife become inner cuts, and what the pen draws inner lines; in a file that cuts nothing
// the pen's lines are the outlines.  Labels such as "S:XL-A M:STYLE N:FRONT" give size, bundle and
// name.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::trade::cut {

// Errors: kEmptyMarker (nothing closed is cut), and those of on_lattice.
[[nodiscard]] Result<MarkerFile> read_cut_marker(std::string_view text, const ReadingOptions& options);

}  // namespace selvage::protocol::trade::cut
