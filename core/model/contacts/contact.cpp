#include "core/model/contacts/contact.h"

#include <algorithm>
#include <cmath>

#include <boost/container/small_vector.hpp>

#include "core/minkowski/edges_near.h"

namespace selvage::model::contacts {
namespace {

// The cosine of the angle between normals that count as the same: about 0.1 degrees.
constexpr double kSameNormal = 1 - 1e-6;
// The sine of the least turn of a corner that is distinguished from a straight edge: along flatter ones, such as those
// of a curve's polygon, the half-planes of both edges let the piece pass.
constexpr double kFlat = 0.2;
// The cosine of the angle between a chord of an arc (core/model/free_region.h) and the arc's normals at its ends: at
// most 0.25 radians.
constexpr double kOnArc = 0.968;
constexpr std::size_t kUsual = 8;  // few positions touch more edges

// An edge near the position, in the frame of the sum with the position as origin.
struct Touched {
  RealVec normal;       // unit, outwards
  RealVec along;        // unit
  double from{}, to{};  // its ends, measured along it
  RealVec out;          // unit, from its nearest point to the position; meaningful with a distance
  double distance{};
};

Touched touched_of(const minkowski::convolution::SumEdge& edge, Vec at) {
  const RealVec line = real(edge.line_to - edge.line_from);
  const double length = std::sqrt(line.x * line.x + line.y * line.y);
  Touched touched;
  touched.along = {line.x / length, line.y / length};
  touched.normal = {touched.along.y, -touched.along.x};
  const RealVec from = real(edge.from - at);
  const RealVec to = real(edge.to - at);
  touched.from = from.x * touched.along.x + from.y * touched.along.y;
  touched.to = to.x * touched.along.x + to.y * touched.along.y;
  const double across = from.x * touched.normal.x + from.y * touched.normal.y;
  const double nearest = std::clamp(0.0, std::min(touched.from, touched.to), std::max(touched.from, touched.to));
  const RealVec point{nearest * touched.along.x + across * touched.normal.x,
                      nearest * touched.along.y + across * touched.normal.y};
  touched.distance = std::sqrt(point.x * point.x + point.y * point.y);
  if (touched.distance > 0) touched.out = {-point.x / touched.distance, -point.y / touched.distance};
  return touched;
}

double dot(RealVec a, RealVec b) {
  return a.x * b.x + a.y * b.y;
}

using TouchedEdges = boost::container::small_vector<Touched, kUsual>;

// True when one of the edges soon stops a point that moves in the direction, or turns it slightly aside.
bool is_obstructed(const TouchedEdges& touched, RealVec direction) {
  return std::any_of(touched.begin(), touched.end(),
                     [&](const Touched& other) { return dot(other.normal, direction) < 0; });
}
bool is_flat(const TouchedEdges& touched, RealVec normal) {
  return std::any_of(touched.begin(), touched.end(), [&](const Touched& other) {
    const double sine = std::abs(other.normal.x * normal.y - other.normal.y * normal.x);
    return sine > 0 && sine < kFlat && dot(other.normal, normal) > 0;
  });
}

Backing backing_along(const Touched& edge, const TouchedEdges& touched, double tolerance) {
  const bool before = edge.from > -tolerance;
  const bool after = edge.to < tolerance;
  const RealVec back{-edge.along.x, -edge.along.y};
  if (!before && !after) return Backing::kEdge;
  if ((!before || is_obstructed(touched, back)) && (!after || is_obstructed(touched, edge.along)))
    return Backing::kEdge;
  return is_flat(touched, edge.normal) ? Backing::kEdge : Backing::kCorner;
}

// The same for a pair that may overlap, whose position is as deep inside the sum as it may be: an edge is in contact
// when its distance is the allowance.  Where the position is nearest to the end of an edge, the boundary turns inwards
// there and the contact is an arc.  Where several edges are in contact, the positions that are not allowed have a
// corner. `touched`: the edges no farther than the allowance.
Backing backing_within(const TouchedEdges& touched, RealVec normal, double allowance, double tolerance) {
  const bool deepest = std::all_of(touched.begin(), touched.end(),
                                   [&](const Touched& edge) { return edge.distance >= allowance - tolerance; });
  if (!deepest) return Backing::kNone;
  Backing best = Backing::kNone;
  for (const Touched& edge : touched) {
    const bool has_foot = dot(edge.out, edge.normal) < -kSameNormal;
    if (!has_foot && -dot(edge.out, normal) > kOnArc) return Backing::kEdge;
    if (!has_foot || dot(edge.normal, normal) < kSameNormal) continue;
    const bool alone = std::all_of(touched.begin(), touched.end(), [&](const Touched& other) {
      return dot(other.normal, edge.normal) >= kSameNormal || dot(other.out, other.normal) >= -kSameNormal;
    });
    if (alone || is_flat(touched, edge.normal)) return Backing::kEdge;
    best = Backing::kCorner;
  }
  return best;
}

}  // namespace

Backing backing_of(const PairRow& row, const PairPosition& position, double tolerance) {
  const Vec at = position.obstacle.to_frame(position.r);
  const auto [nx, ny] = position.obstacle.direction_to_frame(row.nx, row.ny);
  const RealVec normal{nx, ny};
  const double reach = std::abs(static_cast<double>(position.spacing)) + tolerance;
  TouchedEdges touched;
  const Box window = Box{at, at}.grown(std::llround(reach) + 1);
  for_each_edge_near(position.obstacle.sum(), window, [&](const minkowski::convolution::SumEdge& edge) {
    const Touched found = touched_of(edge, at);
    if (found.distance <= reach) touched.push_back(found);
  });
  if (position.spacing < 0) {
    return backing_within(touched, normal, -static_cast<double>(position.spacing), tolerance);
  }
  // About a corner, pieces with a spacing between them meet along an arc: its tangent is a contact like an edge.
  const bool on_arc = static_cast<double>(position.spacing) > tolerance;
  Backing best = Backing::kNone;
  for (const Touched& edge : touched) {
    if (on_arc && dot(edge.out, normal) > kSameNormal) return Backing::kEdge;
    if (on_arc || dot(edge.normal, normal) < kSameNormal) continue;
    if (backing_along(edge, touched, tolerance) == Backing::kEdge) return Backing::kEdge;
    best = Backing::kCorner;
  }
  return best;
}

}  // namespace selvage::model::contacts
