// The nesting XML of ESICUP (github.com/ESICUP/datasets): a lot of pieces, a board, and perhaps solutions.
//
// Its coordinates grow downwards from the upper left ("up-left"); ours grow upwards, so y and angles change sign.  The
// format has no unit: the caller's or millimetres are assumed when it is read, and millimetres are written.  The
// shortest solution places the pieces, with all digits that the file states; without one they lie in columns, as those
// of a pattern do.
//
// The angles of a piece are an enumeration.  The published files have no other form, so free rotation cannot be
// written.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "protocol/document/marker_file.h"
#include "protocol/trade/options.h"

namespace selvage::protocol::trade::esicup {

[[nodiscard]] bool looks_like_esicup(std::string_view text);

// Errors: kSyntax (no well-formed XML), kUnknownFormat (no <nesting> with a lot), kUnknownShape (a piece without its
// polygon), kOutOfRange (too many pieces), and those of on_lattice.
[[nodiscard]] Result<MarkerFile> read_esicup(std::string_view text, const ReadingOptions& options);

// The lot, the board as long as the marker, and the marker as the solution.  A flipped piece is written as a separate
// piece with a mirrored polygon.  Angles are from 0 to less than 360 degrees.  Shapes that may be rotated freely have
// the angles of their pieces.  Characters that XML does not have become blanks, and ids stay different.
[[nodiscard]] std::string esicup_file(const MarkerFile& file);
// What happens to the numbers of a marker that is not in millimetres, as the form states no unit: those of a known unit
// are converted to millimetres.
[[nodiscard]] std::optional<Note> unit_note(const Marker& marker);
[[nodiscard]] bool converts_unit(const Marker& marker);
// This note, and those about what the form does not have and without which the layout may be read as invalid or may be
// turned less freely: overlap allowances, free rotation, tilt limits, the resolution, and characters.
[[nodiscard]] std::vector<Note> esicup_losses(const Marker& marker);

}  // namespace selvage::protocol::trade::esicup
