#include "protocol/formats/outlines.h"

#include <utility>

#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::formats {
namespace {

// The overlap allowance that applies to all pairs of the piece with an allowance.
Coord allowance_of(const Marker& marker, const Piece& piece) {
  return marker.spacing > 0 || piece.buffer > 0 ? 0 : piece.overlap.value_or(marker.overlap);
}

}  // namespace

Json outlines_document(const Marker& marker) {
  Json pieces = Json::array();
  for (std::uint32_t i = 0; i < marker.pieces.size(); ++i) {
    pieces.push_back({{"id", marker.pieces[i].id},
                      {"outline", outline_json(placed_outline(marker, PieceId{i}), marker.resolution)}});
    const Coord allowance = allowance_of(marker, marker.pieces[i]);
    if (allowance > 0) pieces.back()["overlap"] = to_decimal(allowance, marker.resolution);
    if (const marker::Rules& rules = marker.pieces[i].rules; rules != marker::Rules{}) {
      Json& written = pieces.back()["rules"] = schema::encode(decimal_rules(rules, marker.resolution));
      if (rules.nap) written["rotation"] = marker.pieces[i].orientation.rotation.degrees;  // which outlines do not show
      // Where they lie, as the outline: the shape's own coordinates say nothing here.
      if (rules.match) {
        written["match"] = point_json(marker.pieces[i].at + turned_match(marker.pieces[i]), marker.resolution);
      }
      if (rules.part) {
        Polygon part = turned_part(marker.pieces[i]);
        for (Vec& v : part) v = v + marker.pieces[i].at;
        written["part"]["outline"] = outline_json(part, marker.resolution);
      }
    }
  }
  Json document{{"strip_height", to_decimal(marker.strip.width, marker.resolution)},
                {"strip_length", to_decimal(length_of(marker), marker.resolution)}};
  for (const auto& [length, name] :
       {std::pair{marker.strip.below, "below"}, {marker.strip.above, "above"}, {marker.shade, "shade"}}) {
    if (length) document[name] = to_decimal(*length, marker.resolution);
  }
  if (marker.strip.repeat.any()) {
    document["repeat"] = schema::encode(decimal_repeat(marker.strip.repeat, marker.resolution));
  }
  if (marker.strip.tube) document["tube"] = true;
  document["pieces"] = std::move(pieces);
  return document;
}

}  // namespace selvage::protocol::formats
