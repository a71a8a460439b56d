// A marker as PDF at full size: on one page, or on A4 pages to be glued together.
#pragma once

#include <string>

#include "core/base/result.h"
#include "protocol/plots/sheet.h"

namespace selvage::protocol::plots::pdf {

inline constexpr int kMostTiles = 5000;

// One page as large as the marker and 10 mm round it.
[[nodiscard]] std::string pdf_file(const Sheet& sheet);

// A4 pages, row by row from the lower left; crosses mark the corners at which neighbours meet.
// Errors: kOutOfRange when there would be more than kMostTiles pages.
[[nodiscard]] Result<std::string> tiled_pdf_file(const Sheet& sheet);

}  // namespace selvage::protocol::plots::pdf
