#include "core/motion/piece/slide.h"

#include <cmath>
#include <limits>
#include <optional>

namespace selvage::motion::piece {
namespace {

constexpr double kParallel = 1e-12;  // directions this close to parallel with a side do not hit it

struct Hit {
  std::size_t side{};
  double distance{};
};

// The first side that the ray from `at` along (dx, dy) hits, other than `ignored`.
std::optional<Hit> first_hit(std::span<const CellSide> cell, RealVec at, double dx, double dy,
                             std::optional<std::size_t> ignored) {
  std::optional<Hit> first;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    if (k == ignored) continue;
    const double speed = cell[k].nx * dx + cell[k].ny * dy;
    if (speed > -kParallel) continue;
    const double room = cell[k].slack + cell[k].nx * at.x + cell[k].ny * at.y;
    const double distance = std::max(0.0, room) / -speed;
    if (!first || distance < first->distance) first = Hit{k, distance};
  }
  return first;
}

}  // namespace

Slide slide(std::span<const CellSide> cell, double ux, double uy) {
  Slide result;
  double dx = ux;
  double dy = uy;
  std::optional<std::size_t> along;
  for (std::size_t step = 0; step <= 2 * cell.size(); ++step) {
    const auto hit = first_hit(cell, result.to, dx, dy, along);
    if (!hit) break;
    result.to = {result.to.x + hit->distance * dx, result.to.y + hit->distance * dy};
    const CellSide& side = cell[hit->side];
    // Along the new side, in the direction that leads farther, unless the previous side is in the way.
    const double ahead = -side.ny * ux + side.nx * uy;
    dx = ahead > 0 ? -side.ny : side.ny;
    dy = ahead > 0 ? side.nx : -side.nx;
    const bool held = along && cell[*along].nx * dx + cell[*along].ny * dy < -kParallel;
    result.blocking = along ? std::vector{*along, hit->side} : std::vector{hit->side};
    if (std::abs(ahead) <= kParallel || held) break;
    along = hit->side;
  }
  return result;
}

}  // namespace selvage::motion::piece
