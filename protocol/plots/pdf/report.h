// A marker on one A4 page, lying, for people who plan and check markers: the picture, the marker's figures, how often
// each piece occurs, and the critical path, drawn and listed.
#pragma once

#include <string>

#include "protocol/document/marker_file.h"

namespace selvage::protocol::plots::pdf {

// The critical path of a larger marker is left out, and the page says so: it would take longer than a drawing may.
inline constexpr std::size_t kMostPiecesWithPath = 1000;

// A marker that is not valid has no critical path; the page says so.
[[nodiscard]] std::string report_file(const MarkerFile& file);

}  // namespace selvage::protocol::plots::pdf
