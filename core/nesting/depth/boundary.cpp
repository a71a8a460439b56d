#include "core/nesting/depth/boundary.h"

#include <algorithm>

#include "core/nesting/depth/lanes.h"

namespace selvage::nesting::depth {
namespace {

constexpr float kFar = 1e9F;  // model units: coordinate of the padding

}  // namespace

void Boundary::add(float from_x, float from_y, float to_x, float to_y) {
  ax.push_back(from_x);
  ay.push_back(from_y);
  dx.push_back(to_x - from_x);
  dy.push_back(to_y - from_y);
  const float square = dx.back() * dx.back() + dy.back() * dy.back();
  inverse_square.push_back(square > 0 ? 1 / square : 0);
  end_y.push_back(to_y);
  run.push_back(dy.back() != 0 ? dx.back() / dy.back() : 0);
  ++edges;
}

void Boundary::finish() {
  const std::size_t real = edges;
  while (ax.size() % kLanes != 0) add(kFar, kFar, kFar, kFar);
  edges = real;
}

void Boundary::assign_near(const Boundary& whole, const std::vector<float>& squared, float limit) {
  const std::size_t room = whole.edges + kLanes;
  for (auto* component : {&ax, &ay, &dx, &dy, &inverse_square, &end_y, &run}) component->resize(room);
  edges = 0;
  for (std::size_t k = 0; k < whole.edges; ++k) {
    if (squared[k] > limit) continue;
    ax[edges] = whole.ax[k];
    ay[edges] = whole.ay[k];
    dx[edges] = whole.dx[k];
    dy[edges] = whole.dy[k];
    inverse_square[edges] = whole.inverse_square[k];
    end_y[edges] = whole.end_y[k];
    run[edges] = whole.run[k];
    ++edges;
  }
  for (auto* component : {&ax, &ay, &dx, &dy, &inverse_square, &end_y, &run}) component->resize(edges);
  finish();
}

Boundary boundary_of(std::span<const minkowski::convolution::SumEdge> edges, double lattice_units) {
  Boundary boundary;
  for (auto* component : {&boundary.ax, &boundary.ay, &boundary.dx, &boundary.dy, &boundary.inverse_square,
                          &boundary.end_y, &boundary.run}) {
    component->reserve(edges.size() + kLanes);
  }
  const auto units = [lattice_units](Coord coord) {
    return static_cast<float>(static_cast<double>(coord) / lattice_units);
  };
  for (const auto& edge : edges)
    boundary.add(units(edge.from.x), units(edge.from.y), units(edge.to.x), units(edge.to.y));
  boundary.finish();
  return boundary;
}

// In the loops below, `t` is the parameter of the edge's point that is nearest, and (qx, qy) leads from it to the
// point.
// NOLINTBEGIN(bugprone-macro-parentheses): a name that is declared cannot stand in parentheses
#define SELVAGE_LOAD(name, component) \
  Lanes name;                         \
  std::memcpy(&name, (component).data() + k, sizeof name)
// NOLINTEND(bugprone-macro-parentheses)
#define SELVAGE_SQUARED_DISTANCE                  \
  SELVAGE_LOAD(ax, boundary.ax);                  \
  SELVAGE_LOAD(ay, boundary.ay);                  \
  SELVAGE_LOAD(dx, boundary.dx);                  \
  SELVAGE_LOAD(dy, boundary.dy);                  \
  SELVAGE_LOAD(inverse, boundary.inverse_square); \
  const Lanes px = x - ax;                        \
  const Lanes py = y - ay;                        \
  Lanes t = (px * dx + py * dy) * inverse;        \
  t = t < zero ? zero : t;                        \
  t = t > one ? one : t;                          \
  const Lanes qx = px - t * dx;                   \
  const Lanes qy = py - t * dy;                   \
  const Lanes squared = qx * qx + qy * qy;        \
  best = squared < best ? squared : best

// One edge after another, each for all points at once: few edges are near a row of points.
SELVAGE_FOR_EACH_PROCESSOR void squared_distances(const Boundary& boundary, const float* xs, float y, float* squared) {
  const Lanes zero{};
  const Lanes one = zero + 1.0F;
  Lanes best = zero + kFar * kFar;
  Lanes x;
  std::memcpy(&x, xs, sizeof x);
  for (std::size_t k = 0; k < boundary.edges; ++k) {
    const Lanes px = x - boundary.ax[k];
    const float py = y - boundary.ay[k];
    Lanes t = (px * boundary.dx[k] + py * boundary.dy[k]) * boundary.inverse_square[k];
    t = t < zero ? zero : t;
    t = t > one ? one : t;
    const Lanes qx = px - t * boundary.dx[k];
    const Lanes qy = py - t * boundary.dy[k];
    const Lanes found = qx * qx + qy * qy;
    best = found < best ? found : best;
  }
  std::memcpy(squared, &best, sizeof best);
}

SELVAGE_FOR_EACH_PROCESSOR Nearness nearness(const Boundary& boundary, float x, float y) {
  const Lanes zero{};
  const Lanes one = zero + 1.0F;
  Lanes best = zero + kFar * kFar;
  LaneMask parity{};
  for (std::size_t k = 0; k < boundary.ax.size(); k += kLanes) {
    SELVAGE_SQUARED_DISTANCE;
    SELVAGE_LOAD(end_y, boundary.end_y);
    SELVAGE_LOAD(run, boundary.run);
    parity ^= ((ay > y) ^ (end_y > y)) & (px < py * run);
  }
  return {lowest_of(best), odd(parity)};
}

SELVAGE_FOR_EACH_PROCESSOR Nearness nearness_of_each(const Boundary& boundary, float x, float y,
                                                     std::vector<float>& squared_of) {
  const Lanes zero{};
  const Lanes one = zero + 1.0F;
  Lanes best = zero + kFar * kFar;
  LaneMask parity{};
  squared_of.resize(boundary.ax.size());
  for (std::size_t k = 0; k < boundary.ax.size(); k += kLanes) {
    SELVAGE_SQUARED_DISTANCE;
    SELVAGE_LOAD(end_y, boundary.end_y);
    SELVAGE_LOAD(run, boundary.run);
    parity ^= ((ay > y) ^ (end_y > y)) & (px < py * run);
    std::memcpy(squared_of.data() + k, &squared, sizeof squared);
  }
  return {lowest_of(best), odd(parity)};
}

// The segment from (from_x, from_y) to (x, y) crosses an edge when each separates the other's ends.
SELVAGE_FOR_EACH_PROCESSOR Nearness nearness_along(const Boundary& boundary, float from_x, float from_y,
                                                   bool from_inside, float x, float y) {
  const Lanes zero{};
  const Lanes one = zero + 1.0F;
  Lanes best = zero + kFar * kFar;
  LaneMask parity{};
  const float step_x = x - from_x;
  const float step_y = y - from_y;
  for (std::size_t k = 0; k < boundary.ax.size(); k += kLanes) {
    SELVAGE_SQUARED_DISTANCE;
    const Lanes wx = from_x - ax;
    const Lanes wy = from_y - ay;
    const Lanes start_side = dx * wy - dy * wx;
    const Lanes end_side = dx * py - dy * px;
    const Lanes edge_start_side = step_y * wx - step_x * wy;
    const Lanes edge_end_side = edge_start_side + (step_x * dy - step_y * dx);
    parity ^= ((start_side > zero) ^ (end_side > zero)) & ((edge_start_side > zero) ^ (edge_end_side > zero));
  }
  return {lowest_of(best), odd(parity) != from_inside};
}

#undef SELVAGE_SQUARED_DISTANCE
#undef SELVAGE_LOAD

}  // namespace selvage::nesting::depth
