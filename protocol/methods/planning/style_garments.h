// The garments of a style that is open as a marker: a piece belongs to the size that its attributes name, or those of
// its shape (protocol/document/piece_label.h).
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/planning/making/garments.h"
#include "protocol/document/marker_file.h"

namespace selvage::protocol::methods::planning {

// One bundle of each of the sizes.
// Errors: kOutOfRange for a marker that is not in millimetres, a piece without a size, and a size that no piece has;
// the last of them points to /quantities.
[[nodiscard]] Result<selvage::planning::making::Garments> garments_of(const MarkerFile& style,
                                                                      const std::vector<std::string>& sizes);

}  // namespace selvage::protocol::methods::planning
