// Drawings in SVG as patterns: every outermost closed outline is a piece.
//
// Units: those of width and viewBox, otherwise the caller's, otherwise CSS pixels of 1/96 inch.  Elements inside a
// piece become annotations.  Of FreeSewing's classes "sa" is the cut line, and "fabric", "lining" and "interfacing" the
// material; its markers identify the grain line and the line to cut on the fold.  Elements that are not shown are left
// out: definitions, display: none, and the class "hidden".
#pragma once

#include <string_view>

#include "core/base/result.h"
#include "protocol/trade/options.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::svg {

[[nodiscard]] bool looks_like_svg(std::string_view text);

// Errors: kSyntax (no well-formed XML), kUnknownFormat (no closed outline).
[[nodiscard]] Result<Style> read_svg_pattern(std::string_view text, const ReadingOptions& options);

}  // namespace selvage::protocol::trade::svg
