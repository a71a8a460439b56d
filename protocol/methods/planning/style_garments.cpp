#include "protocol/methods/planning/style_garments.h"

#include <algorithm>
#include <set>

#include "protocol/document/piece_label.h"
#include "protocol/json/json_text.h"

namespace selvage::protocol::methods::planning {
Result<selvage::planning::making::Garments> garments_of(const MarkerFile& style,
                                                        const std::vector<std::string>& sizes) {
  if (style.marker.unit != "mm") {
    return Error{ErrorCode::kOutOfRange,
                 "the style is in " + json::shortened(Json(style.marker.unit)) + "; plans are made of styles in mm",
                 "/markerId"};
  }
  selvage::planning::making::Garments garments{style.marker, std::vector<std::vector<std::size_t>>(sizes.size())};
  std::set<std::string> known;
  const std::size_t pieces = style.marker.pieces.size() + style.marker.unplaced.size();
  for (std::size_t position = 0; position < pieces; ++position) {
    const bool placed = position < style.marker.pieces.size();
    if (placed && style.marker.pieces[position].rules.zone) continue;  // of its cloth, not of the style
    const std::string size = document::size_of_piece(style, position);
    if (size.empty()) {
      return Error{ErrorCode::kOutOfRange,
                   "a piece of the style has no size: its attributes, or those of its shape, must name it",
                   "/markerId"};
    }
    known.insert(size);
    const auto found = std::find(sizes.begin(), sizes.end(), size);
    if (found != sizes.end()) garments.sizes[static_cast<std::size_t>(found - sizes.begin())].push_back(position);
  }
  for (std::size_t size = 0; size < sizes.size(); ++size) {
    if (!garments.sizes[size].empty()) continue;
    std::string all;
    for (const std::string& one : known) all += (all.empty() ? "" : ", ") + one;
    return Error{ErrorCode::kOutOfRange,
                 "size " + json::shortened(Json(sizes[size])) + " is not in the style; its sizes are " + all,
                 "/quantities"};
  }
  return garments;
}

}  // namespace selvage::protocol::methods::planning
