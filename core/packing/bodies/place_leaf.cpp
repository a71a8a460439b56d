#include "core/packing/bodies/place_leaf.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/model/snap.h"
#include "core/motion/repair/repair.h"
#include "core/scene/scene.h"

namespace selvage::packing::bodies {
namespace {

using programs::Columns;
using programs::Dictionary;
using programs::Row;

constexpr double kTolerance = 1e-13;  // of the program, in widths: a small part of a unit

// Rounding moves each of two positions by less than a unit on an axis, together by less than one.
double margin_of(const cells::HalfPlane& plane) {
  const bool along_axis = plane.nx == 0 || plane.ny == 0;
  return along_axis ? 0 : std::abs(plane.nx) + std::abs(plane.ny);
}

std::optional<std::vector<RealVec>> solved(const Bodies& bodies, const branching::Leaf& leaf, const Columns& columns,
                                           bool margins) {
  const std::uint32_t world = bodies.problem.world();
  Dictionary program{columns, bodies.problem.minimises_length};
  for (std::uint32_t body = 0; body < world; ++body) {
    const branching::BodyVariant& variant = bodies.problem.bodies[body].variants[leaf.variant[body]];
    program.add(columns, {body, world, false, {1, 0, -variant.range.high_x}});
    program.add(columns, {body, world, false, {0, 1, -variant.range.high_y}});
    program.add(columns, {world, body, false, {1, 0, variant.range.low_x}});
    program.add(columns, {world, body, false, {0, 1, variant.range.low_y}});
    if (bodies.problem.minimises_length) program.add(columns, {body, body, true, {1, 0, variant.width}});
  }
  for (Row row : leaf.rows) {
    if (margins) row.plane.c += margin_of(row.plane);
    program.add(columns, row);
  }
  std::uint64_t pivots = 0;
  const double none = std::numeric_limits<double>::infinity();
  if (program.solve(columns, none, pivots, kTolerance) != Dictionary::End::kOptimal) return std::nullopt;
  std::vector<RealVec> positions;
  for (std::uint32_t body = 0; body < world; ++body) positions.push_back(program.position(columns, body));
  return positions;
}

std::vector<RealVec> snapped_to_lattice(const std::vector<RealVec>& positions) {
  std::vector<RealVec> whole;
  for (const Vec at : model::snapped(positions)) whole.push_back(geometry::real(at));
  return whole;
}

// The bodies' positions once the small overlaps of a layout are repaired; all other pieces stay.
std::optional<std::vector<RealVec>> repaired(Marker layout, const Bodies& bodies, const branching::Leaf& leaf,
                                             const scene::Run& run) {
  std::vector<bool> moving(layout.pieces.size());
  for (const auto& body : bodies.pieces) {
    for (const std::uint32_t piece : body) moving[piece] = true;
  }
  for (std::size_t k = 0; k < moving.size(); ++k) {
    if (!moving[k]) layout.pieces[k].locked = true;
  }
  scene::Scene scene{std::move(layout), run.sums};
  // Leaves are placed concurrently, so nothing is reported.
  if (!motion::repair::repair_overlaps(scene, {run.sums, run.stop})) return std::nullopt;
  std::vector<RealVec> positions;
  for (std::size_t body = 0; body < bodies.pieces.size(); ++body) {
    const Vec offset = bodies.layouts[body][leaf.variant[body]].offsets.front();
    positions.push_back(geometry::real(scene.pieces.at(bodies.pieces[body].front()) - offset));
  }
  return positions;
}

// True when the piece keeps the clearance from the ends of its room, too; the fold is none of them.
bool has_clearance(const marker::PlacedPieces& pieces, std::uint32_t piece, const Marker& marker, Coord clearance) {
  if (clearance == 0 || marker.pieces[piece].rules.on_fold) return true;
  return pieces.room(piece, marker.strip, kLatticeLimit).grown(-clearance).contains(pieces.box(piece));
}

bool is_proved(const Marker& marker, const Bodies& bodies, const Freedom& freedom) {
  const marker::PlacedPieces pieces{marker};
  std::vector<std::uint32_t> changed;
  for (const auto& body : bodies.pieces) changed.insert(changed.end(), body.begin(), body.end());
  const outline::Container& container = freedom.container;
  for (const std::uint32_t piece : changed) {
    if (!container.box.contains(pieces.box(piece)) || protrusion_of(pieces, piece, marker.strip) > 0) return false;
    if (!has_clearance(pieces, piece, marker, freedom.clearance)) return false;
    for (const Polygon& wall : container.walls) {
      if (marker::collide(pieces[piece], {wall, box_of(wall), {}}, freedom.clearance)) return false;
    }
  }
  return keep_shades(pieces) && are_clear(pieces, changed);
}

}  // namespace

bool place_leaf(const Marker& marker, const Bodies& bodies, const Freedom& freedom, const scene::Run& run,
                branching::Leaf& leaf) {
  const Columns columns = branching::columns_of(bodies.problem);
  const std::vector<RealVec> original = leaf.positions;
  const auto attempt = [&](std::vector<RealVec> positions) {
    leaf.positions = std::move(positions);
    const Marker layout = placed(marker, bodies, leaf);
    if (!is_proved(layout, bodies, freedom)) return false;
    leaf.length = static_cast<double>(length_of(layout));
    return true;
  };
  if (attempt(leaf.positions)) return true;
  for (const bool margins : {true, false}) {
    const auto positions = solved(bodies, leaf, columns, margins);
    if (positions && (attempt(snapped_to_lattice(*positions)) || attempt(*positions))) return true;
  }
  leaf.positions = original;
  const auto positions = repaired(placed(marker, bodies, leaf), bodies, leaf, run);
  return positions && attempt(*positions);
}

}  // namespace selvage::packing::bodies
