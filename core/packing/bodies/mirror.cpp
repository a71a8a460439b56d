#include "core/packing/bodies/mirror.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace selvage::packing::bodies {
namespace {

// The outline with its box's low corner at the origin.
Polygon at_origin(const Polygon& outline) {
  return geometry::normal_form(outline, -box_of(outline).low);
}

// Whether the outline is its own image when its coordinates are multiplied by these signs.
bool is_own_image(const Polygon& outline, Coord x, Coord y) {
  Polygon image = outline;
  for (Vec& vertex : image) vertex = {x * vertex.x, y * vertex.y};
  if (x != y) std::reverse(image.begin(), image.end());
  return at_origin(image) == at_origin(outline);
}

// The middle one of the bodies of a kind of which there is an odd number; of the largest such kind.
std::optional<std::uint32_t> middle_body(const branching::Problem& problem) {
  std::optional<std::uint32_t> best;
  for (std::uint32_t kind = 0; kind < problem.bodies.size(); ++kind) {
    std::vector<std::uint32_t> alike;
    for (std::uint32_t body = 0; body < problem.bodies.size(); ++body) {
      if (problem.bodies[body].kind == kind) alike.push_back(body);
    }
    if (alike.size() % 2 == 0) continue;
    const std::uint32_t middle = alike[alike.size() / 2];
    if (!best || problem.bodies[middle].area > problem.bodies[*best].area) best = middle;
  }
  return best;
}

}  // namespace

void leave_out_mirror_images(const Marker& marker, const Freedom& freedom, Bodies& bodies) {
  branching::Problem& problem = bodies.problem;
  const bool whole = bodies.pieces.size() == marker.pieces.size() && freedom.container.walls.empty();
  if (!whole || problem.bodies.size() < 2) return;
  bool across = true;
  bool along = true;
  bool half_turn = true;
  for (std::size_t body = 0; body < bodies.pieces.size(); ++body) {
    const Piece& piece = marker.pieces[bodies.pieces[body].front()];
    if (bodies.layouts[body].size() != 1 || piece.locked.x || piece.locked.y) return;
    if (piece.rules != marker::Rules{}) return;
    const Orientation& orientation = bodies.layouts[body].front().orientations.front();
    const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, orientation);
    across = across && is_own_image(outline, 1, -1);
    along = along && is_own_image(outline, -1, 1);
    half_turn = half_turn && is_own_image(outline, -1, -1);
  }
  if (along || half_turn) problem.left_half = middle_body(problem);
  if (!across) return;
  const auto larger = [](const branching::Body& a, const branching::Body& b) { return a.area < b.area; };
  auto& range = std::max_element(problem.bodies.begin(), problem.bodies.end(), larger)->variants.front().range;
  range.high_y = std::ceil((range.low_y + range.high_y) / 2);
}

}  // namespace selvage::packing::bodies
