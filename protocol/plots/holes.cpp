#include "protocol/plots/holes.h"

#include <algorithm>
#include <cmath>

#include "protocol/drawing/label_spot.h"

namespace selvage::protocol::plots {
namespace {

constexpr double kFine = 100;  // lattice units of a millimetre

// Counter-clockwise; empty if nothing is enclosed.
Polygon polygon_of(const std::vector<Spot>& points) {
  Polygon polygon;
  for (const Spot& point : points) {
    const Vec vertex{std::llround(point.x * kFine), std::llround(point.y * kFine)};
    if (polygon.empty() || polygon.back() != vertex) polygon.push_back(vertex);
  }
  const auto area = polygon.size() < 3 ? 0 : geometry::doubled_area(polygon);
  if (area == 0) return {};
  if (area < 0) std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

std::vector<Polygon> holes_of(const SheetPiece& piece) {
  std::vector<Polygon> holes;
  for (const document::DrawnLine& line : piece.annotations.lines) {
    if (!line.closed || line.kind != document::LineKind::kCutOut) continue;
    if (Polygon hole = polygon_of(line.points); !hole.empty()) holes.push_back(std::move(hole));
  }
  return holes;
}

}  // namespace

LabelPlace label_place(const SheetPiece& piece, double aspect, double largest) {
  const Polygon outline = polygon_of(piece.outline);
  if (outline.empty()) return {piece.outline.front(), 0, false};
  const auto spot = drawing::find_label_spot(outline, aspect, largest / 2 * kFine, holes_of(piece));
  return {{spot.x / kFine, spot.y / kFine}, std::min(largest, 2 * spot.half_height / kFine), spot.upright};
}

std::vector<std::vector<std::size_t>> pieces_in_holes(const Sheet& sheet) {
  std::vector<std::vector<std::size_t>> inner(sheet.pieces.size());
  std::vector<Vec> inside;  // a point of each piece, well inside
  for (std::size_t k = 0; k < sheet.pieces.size(); ++k) {
    for (const Polygon& hole : holes_of(sheet.pieces[k])) {
      for (std::size_t other = inside.size(); other < sheet.pieces.size(); ++other) {
        const Spot spot = label_place(sheet.pieces[other], 1, INFINITY).middle;
        inside.push_back({std::llround(spot.x * kFine), std::llround(spot.y * kFine)});
      }
      const Box box = box_of(hole);
      for (std::size_t other = 0; other < sheet.pieces.size(); ++other) {
        const Vec at = inside[other];
        if (at.x < box.low.x || at.x > box.high.x || at.y < box.low.y || at.y > box.high.y) continue;
        if (other != k && locate(at, hole) == geometry::Location::kInside) inner[k].push_back(other);
      }
    }
  }
  return inner;
}

}  // namespace selvage::protocol::plots
