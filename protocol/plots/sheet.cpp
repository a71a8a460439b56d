#include "protocol/plots/sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/outline/enclosed/slit.h"
#include "protocol/document/frame.h"

namespace selvage::protocol::plots {
namespace {

std::string text_in(const Json& attributes, const char* key) {
  const Json* const found = attributes.find(key);
  return found && found->is_string() ? found->get<std::string>() : std::string{};
}

// "FRONT/S R1", and the bundle if the id does not contain it.
std::string label_of(const Piece& piece, const Json& attributes) {
  const std::string bundle = text_in(attributes, "bundle");
  if (bundle.empty() || piece.id.find(bundle) != std::string::npos) return piece.id;
  return piece.id + " " + bundle;
}

document::Annotations scaled(document::Annotations annotations, double factor) {
  if (factor == 1) return annotations;
  const auto scale = [factor](Spot& spot) { spot = {spot.x * factor, spot.y * factor}; };
  for (document::Notch& notch : annotations.notches) {
    scale(notch.at);
    notch.depth *= factor;
    notch.width *= factor;
  }
  for (Spot& drill : annotations.drills) scale(drill);
  for (document::DrawnLine& line : annotations.lines) {
    for (Spot& point : line.points) scale(point);
  }
  for (document::DrawnText& text : annotations.texts) {
    scale(text.at);
    text.height *= factor;
  }
  return annotations;
}

// Adds open holes as cut-outs, unless the piece has cut-outs already, of which the holes were made.
void add_cut_outs(document::Annotations& annotations, const std::vector<std::vector<Spot>>& holes) {
  const bool has_cut_outs = std::any_of(
      annotations.lines.begin(), annotations.lines.end(),
      [](const document::DrawnLine& line) { return line.kind == document::LineKind::kCutOut && line.closed; });
  if (has_cut_outs) return;
  for (const std::vector<Spot>& hole : holes) annotations.lines.push_back({document::LineKind::kCutOut, true, hole});
}

}  // namespace

double millimetres_in(const std::string& unit) {
  for (const auto& [word, factor] : {std::pair{"mm", 1.0},
                                     {"cm", 10.0},
                                     {"m", 1000.0},
                                     {"in", 25.4},
                                     {"inch", 25.4},
                                     {"ft", 304.8},
                                     {"yd", 914.4}}) {
    if (unit == word) return factor;
  }
  return 1;
}

Sheet sheet_of(const MarkerFile& file) {
  const Marker& marker = file.marker;
  const double unit = millimetres_in(marker.unit);
  const auto decimal = [&](Coord coord) { return to_decimal(coord, marker.resolution) * unit; };
  Sheet sheet{marker.name, decimal(marker.strip.width), decimal(length_of(marker)), utilisation_of(marker), {}};
  const auto spots = [&](const Polygon& polygon) {
    std::vector<Spot> list;
    for (const Vec vertex : polygon) list.push_back({decimal(vertex.x), decimal(vertex.y)});
    return list;
  };
  std::vector<document::Annotations> of_shapes;
  for (const Json& attributes : file.attributes.shapes) {
    of_shapes.push_back(scaled(document::annotations_of(attributes), unit));
  }
  for (std::uint32_t k = 0; k < marker.pieces.size(); ++k) {
    const Piece& piece = marker.pieces[k];
    if (piece.rules.zone) continue;  // nothing to cut
    SheetPiece placed{piece.id, label_of(piece, file.attributes.pieces[k]), {}, {}};
    const outline::enclosed::Rings rings = outline::enclosed::without_slits(placed_outline(marker, PieceId{k}));
    placed.outline = spots(rings.outline);
    const document::Annotations& annotations = of_shapes[piece.shape.value];
    if (!annotations.empty()) {
      const Orientation& o = piece.orientation;
      placed.annotations = document::placed(
          annotations, {o.flip, o.rotation.degrees + o.tilt.degrees, {decimal(piece.at.x), decimal(piece.at.y)}});
    }
    std::vector<std::vector<Spot>> holes;
    for (const Polygon& hole : rings.holes) holes.push_back(spots(hole));
    add_cut_outs(placed.annotations, holes);
    sheet.pieces.push_back(std::move(placed));
  }
  return sheet;
}

std::string in_ascii(std::string_view text, char otherwise) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f)
      out += c;
    else if ((byte & 0xc0) != 0x80)
      out += otherwise;  // one for each character of UTF-8
  }
  return out;
}

std::string thousandths(double value) {
  return json::number_text(std::round(value * 1000) / 1000 + 0.0);
}

}  // namespace selvage::protocol::plots
