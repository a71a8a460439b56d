// Pattern files: AAMA/ASTM D6673 DXF, as written by six programs whose files were examined.
//
// The unit is the caller's, otherwise that of the text "Units:", otherwise $INSUNITS; without any the file is refused.
// A piece's outline is the largest closed loop of layer 1, a half piece is unfolded about its mirror line, and every
// piece is turned so that its grain lies along x.  A graded nest has a block for every size; otherwise the rule table
// makes the sizes.  Oddities of a file are reported in the style's notes, by line.
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::aama {

// Errors: those of read_tags, read_drawing and read_rule_table; kUnknownFormat (no pattern pieces), kMissingField (no
// unit), kOutOfRange (a size that the style does not have), kTooFewVertices (a boundary that is not closed).
[[nodiscard]] Result<Style> read_pattern(std::string_view text, const ReadingOptions& options);

}  // namespace selvage::protocol::trade::aama
