// A marker on one A4 page in landscape format, for people who plan and check markers: the picture, the figures, the
// number of copies of each piece, and the critical path, drawn and listed.
#pragma once

#include <string>

#include "protocol/document/marker_file.h"

namespace selvage::protocol::plots::pdf {

// For a larger marker the critical path would take too long, so it is left out, and the page says so.
inline constexpr std::size_t kMostPiecesWithPath = 1000;

// A marker that is not valid has no critical path; the page says so.
[[nodiscard]] std::string report_file(const MarkerFile& file);

}  // namespace selvage::protocol::plots::pdf
