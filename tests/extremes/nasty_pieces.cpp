#include "tests/extremes/nasty_pieces.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/support/polygons.h"

namespace selvage::test {
namespace {

// The vertices as a Polygon; throws when any of them is redundant.
Polygon whole(const std::vector<Vec>& vertices) {
  auto clean = clean_polygon(vertices);
  if (!clean || clean->polygon.size() != vertices.size()) throw std::logic_error{"not a polygon as it stands"};
  return std::move(clean->polygon);
}

// A staircase with steps of one unit and a vertical back.
Polygon unit_steps(Coord steps) {
  std::vector<Vec> vertices{{0, 0}};
  for (Coord k = 0; k < steps; ++k) {
    vertices.push_back({steps + 1 - k, k});
    vertices.push_back({steps + 1 - k, k + 1});
  }
  vertices.push_back({0, steps});
  return whole(vertices);
}

// A shape whose lower side is a chain of edges that turn by `rise` units over `run` units.
Polygon shallow_bowl(Coord edges, Coord run, Coord rise) {
  std::vector<Vec> vertices;
  for (Coord k = 0; k <= edges; ++k) vertices.push_back({k * run, rise * k * (k - edges)});
  vertices.push_back({edges * run, run});
  vertices.push_back({0, run});
  return whole(vertices);
}

Polygon spiked_block(Coord spikes, Coord height) {
  std::vector<Vec> vertices{{0, 0}, {spikes * 1000, 0}};
  for (Coord k = spikes; k-- > 0;) {
    const Coord x = k * 1000 + 500;
    for (const Vec v : {Vec{x + 1, height / 10}, Vec{x, height}, Vec{x - 1, height / 10}}) vertices.push_back(v);
  }
  vertices.push_back({0, height / 10});
  vertices[1].y = 0;
  vertices.insert(vertices.begin() + 2, {spikes * 1000, height / 10});
  return clean_polygon(vertices)->polygon;  // the top of the block between two spikes is straight
}

// A regular polygon, as accurate as the lattice allows.
Polygon circle(int vertices, double radius) {
  std::vector<Vec> round;
  for (int k = 0; k < vertices; ++k) {
    const double angle = 2 * std::numbers::pi * k / vertices;
    round.push_back({std::llround(radius * std::cos(angle)), std::llround(radius * std::sin(angle))});
  }
  return whole(round);
}

// A square with a jagged outline: neighbouring vertices are one or two units apart.
Polygon frayed(Coord side) {
  std::vector<Vec> vertices;
  const auto fray = [](Coord k) { return k % 2; };
  for (Coord k = 0; k < side; ++k) vertices.push_back({k, -fray(k)});
  for (Coord k = 0; k < side; ++k) vertices.push_back({side + fray(k), k});
  for (Coord k = 0; k < side; ++k) vertices.push_back({side - k, side + fray(k)});
  for (Coord k = 0; k < side; ++k) vertices.push_back({-fray(k), side - k});
  return whole(vertices);
}

}  // namespace

Polygon pinwheel(Coord arm) {
  return whole({{1, -1}, {arm, -1}, {1, 1}, {1, arm}, {-1, 1}, {-arm, 1}, {-1, -1}, {-1, -arm}});
}

std::vector<NastyPiece> nasty_pieces() {
  constexpr Coord kLarge = Coord{1} << 28;
  constexpr Coord kTrillion = 1'000'000'000'000;
  Random random{5};
  return {
      {.name = "sliver_of_aspect_1e6",
       .outline = whole({{0, 0}, {1'000'000'000, 0}, {1'000'000'000, 1000}, {0, 1000}}),
       .sum_judged = true},
      {.name = "slanted_sliver_of_aspect_1e6",
       .outline = whole({{0, 0}, {1'000'000'000, 99'999'999}, {999'999'901, 100'000'994}, {-99, 995}}),
       .sum_judged = true},
      {.name = "needle_of_one_unit",
       .outline = whole({{0, 0}, {1'000'000, 0}, {1'000'000, 1}, {0, 1}}),
       .sum_judged = true},
      {.name = "triangle_of_one_unit", .outline = whole({{0, 0}, {1, 0}, {0, 1}}), .sum_judged = true},
      {.name = "least_triangle_of_all",
       .outline = whole({{0, 0}, {kTrillion, 1}, {kTrillion - 1, 1}}),
       .stacked = true,
       .sum_judged = true},
      {.name = "edges_at_1e-12_rad",
       .outline = whole({{0, 0}, {kTrillion, 0}, {kTrillion, 1001}, {0, 1000}}),
       .stacked = true,
       .sum_judged = true},
      {.name = "edges_of_one_unit", .outline = unit_steps(998)},
      {.name = "bowl_of_turns_of_2e-6", .outline = shallow_bowl(400, 1'000'000, 1)},
      {.name = "bowl_of_turns_of_2e-9", .outline = shallow_bowl(30, 1'000'000'000, 1), .sum_judged = true},
      {.name = "spikes_of_2_by_1e8", .outline = spiked_block(40, 100'000'000)},
      {.name = "saw_of_500_teeth", .outline = saw(500, 2000, 1'000'000), .many_parts = true},
      {.name = "comb_of_499_teeth", .outline = random_comb(random, 499, kLarge, false), .many_parts = true},
      {.name = "spiral_of_70_turns", .outline = spiral(70, kLarge)},
      {.name = "kernel_of_one_unit", .outline = pinwheel(kLarge), .sum_judged = true},
      {.name = "circle_of_2000", .outline = circle(2000, static_cast<double>(kLarge))},
      {.name = "star_of_2000", .outline = random_star(random, 2000, kLarge)},
      {.name = "vertices_one_or_two_apart", .outline = frayed(499)},
      {.name = "ring_open_by_one_unit", .outline = broken_ring(1'000'001, 1000, 1), .sum_judged = true},
  };
}

std::vector<NastyPiece> pieces_with_judged_sums() {
  std::vector<NastyPiece> pieces = nasty_pieces();
  std::erase_if(pieces, [](const NastyPiece& piece) { return !piece.sum_judged; });
  return pieces;
}

}  // namespace selvage::test
