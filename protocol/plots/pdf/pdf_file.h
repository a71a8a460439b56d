// A marker as PDF in full size: on one page, or on A4 pages that are glued together.
#pragma once

#include <string>

#include "core/base/result.h"
#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots::pdf {

inline constexpr int kMostTiles = 5000;

// One page with the size of the marker plus 10 mm on each side.
[[nodiscard]] std::string pdf_file(const Sheet& sheet);

// A4 pages, row by row from the lower left; crosses mark the corners where adjacent pages meet.  Errors: kOutOfRange
// when there would be more than kMostTiles pages.
[[nodiscard]] Result<std::string> tiled_pdf_file(const Sheet& sheet);

}  // namespace selvage::protocol::plots::pdf
