#include "protocol/formats/outlines.h"

#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::formats {

Json outlines_document(const Marker& marker) {
  Json pieces = Json::array();
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    pieces.push_back({{"id", marker.pieces[i].id},
                      {"outline", outline_json(placed_outline(marker, PieceId{i}), marker.resolution)}});
  }
  return {{"strip_height", to_decimal(marker.strip.width, marker.resolution)},
          {"strip_length", to_decimal(length_of(marker), marker.resolution)},
          {"pieces", std::move(pieces)}};
}

}  // namespace selvage::protocol::formats
