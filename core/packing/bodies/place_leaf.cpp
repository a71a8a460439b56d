#include "core/packing/bodies/place_leaf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/model/snap.h"
#include "core/motion/repair/repair.h"
#include "core/packing/bodies/lattice_point.h"
#include "core/scene/scene.h"

namespace selvage::packing::bodies {
namespace {

using programs::Columns;
using programs::Dictionary;
using programs::Row;

constexpr double kTolerance = 1e-13;  // of the program, in widths: a small part of a unit

// How far bodies may move from the solution of a leaf: in widths of their ranges, and at least; lattice units.
constexpr double kReach = 1e-4;
constexpr double kLeastReach = 64;

constexpr int kLatticeSweeps = 3;
constexpr double kKept = 1e-4;  // lattice units: a line that a lattice point is beyond by less counts as kept

// The room that contacts are given when nothing else helps: `part` of the spacing and so many lattice units.  Rings
// leave out up to a hundredth of the spacing at corners, and on coarse lattices some units (spaced_rings.h).
struct Room {
  double part{}, units{};
};
constexpr std::array<Room, 3> kRooms{{{0, 0}, {0.01, 2}, {0.05, 4}}};

// Rounding moves each of two positions by less than a unit on an axis, together by less than one.
double margin_of(const cells::HalfPlane& plane) {
  const bool along_axis = plane.nx == 0 || plane.ny == 0;
  return along_axis ? 0 : std::abs(plane.nx) + std::abs(plane.ny);
}

constexpr double kUnlimited = std::numeric_limits<double>::infinity();

bool has_solution(Dictionary& program, const Columns& columns) {
  std::uint64_t pivots = 0;
  return program.solve(columns, kUnlimited, pivots, kTolerance) == Dictionary::End::kOptimal;
}

std::vector<RealVec> positions_in(const Dictionary& program, const Columns& columns) {
  std::vector<RealVec> positions;
  for (std::uint32_t body = 0; body < columns.bodies; ++body) positions.push_back(program.position(columns, body));
  return positions;
}

// The part of a range that is near to the point: the lines of a leaf hold near its solution, and elsewhere another
// piece may be in the way.
RealBox around(RealVec point, const RealBox& range) {
  const double reach = std::max(kLeastReach, kReach * std::max(range.width(), range.height()));
  return {
      std::clamp(point.x - reach, range.low_x, range.high_x), std::clamp(point.y - reach, range.low_y, range.high_y),
      std::clamp(point.x + reach, range.low_x, range.high_x), std::clamp(point.y + reach, range.low_y, range.high_y)};
}

// The leaf's program with exact lines.
struct ProgramKind {
  bool near{};     // bodies stay near the solution
  bool margins{};  // slanted contacts get their margins
};
Dictionary program_of(const Bodies& bodies, const branching::Leaf& leaf, const Columns& columns, ProgramKind kind) {
  const std::uint32_t world = bodies.problem.world();
  Dictionary program{columns, bodies.problem.minimises_length};
  for (std::uint32_t body = 0; body < world; ++body) {
    const branching::BodyVariant& variant = bodies.problem.bodies[body].variants[leaf.variant[body]];
    const RealBox range = kind.near ? around(leaf.positions[body], variant.range) : variant.range;
    program.add(columns, {body, world, false, {1, 0, -range.high_x}});
    program.add(columns, {body, world, false, {0, 1, -range.high_y}});
    program.add(columns, {world, body, false, {1, 0, range.low_x}});
    program.add(columns, {world, body, false, {0, 1, range.low_y}});
    if (bodies.problem.minimises_length) program.add(columns, {body, body, true, {1, 0, variant.width}});
  }
  for (Row row : leaf.rows) {
    if (kind.margins) row.plane.c += margin_of(row.plane);
    program.add(columns, row);
  }
  return program;
}

std::optional<std::vector<RealVec>> solved(const Bodies& bodies, const branching::Leaf& leaf, const Columns& columns,
                                           ProgramKind kind) {
  Dictionary program = program_of(bodies, leaf, columns, kind);
  if (!has_solution(program, columns)) return std::nullopt;
  return positions_in(program, columns);
}

// The room that the solution leaves a row, which is one of two positions.
double room_in(const Dictionary& program, const Columns& columns, const Row& row) {
  const auto at = [&](std::uint32_t body) {
    return body == columns.bodies ? RealVec{} : program.position(columns, body);
  };
  const RealVec first = at(row.first);
  const RealVec second = at(row.second);
  return row.plane.room({second.x - first.x, second.y - first.y});
}

// A solution in which most rows have so much room, or their margin where that is more; lattice units.  Rows that lack
// it are given it one after another, as far as there is a solution.
std::optional<std::vector<RealVec>> with_room(const Bodies& bodies, const branching::Leaf& leaf, const Columns& columns,
                                              double room) {
  Dictionary program = program_of(bodies, leaf, columns, {});
  if (!has_solution(program, columns)) return std::nullopt;
  std::vector<bool> tried(leaf.rows.size());
  for (bool any = true; any;) {
    any = false;
    for (std::size_t k = 0; k < leaf.rows.size(); ++k) {
      Row row = leaf.rows[k];
      const double wanted = std::max(room, margin_of(row.plane));
      if (tried[k] || room_in(program, columns, row) >= wanted) continue;
      any = tried[k] = true;
      row.plane.c += wanted;
      Dictionary narrower = program;
      narrower.add(columns, row);
      if (has_solution(narrower, columns)) program = std::move(narrower);
    }
  }
  return positions_in(program, columns);
}

std::vector<RealVec> snapped_to_lattice(const std::vector<RealVec>& positions) {
  std::vector<RealVec> whole;
  for (const Vec at : model::snapped(positions)) whole.push_back(geometry::real(at));
  return whole;
}

// Where a body may lie while the others stay, by the leaf's lines between it and the plane, or a body that counts.
template <class Counts>
std::vector<cells::HalfPlane> planes_of(const branching::Leaf& leaf, const std::vector<RealVec>& positions,
                                        std::uint32_t body, const Counts& counts) {
  const auto is_plane = [&](std::uint32_t other) { return other == positions.size(); };
  const auto at = [&](std::uint32_t other) { return is_plane(other) ? RealVec{} : positions[other]; };
  std::vector<cells::HalfPlane> planes;
  for (const Row& row : leaf.rows) {
    if (row.first != body && row.second != body) continue;
    const std::uint32_t other = row.first == body ? row.second : row.first;
    if (!is_plane(other) && !counts(other)) continue;
    const cells::HalfPlane& plane = row.plane;
    if (row.second == body) planes.push_back({plane.nx, plane.ny, plane.room(at(other)) + 2 * plane.c});
    if (row.first == body) planes.push_back({-plane.nx, -plane.ny, -plane.room(at(other))});
  }
  return planes;
}

// Moves bodies that violate a line to lattice points nearby that violate none, one after another.
void step_on_lattice(const Bodies& bodies, const branching::Leaf& leaf, std::vector<RealVec>& positions) {
  const auto everybody = [](std::uint32_t) { return true; };
  bool any = true;
  for (int sweep = 0; sweep < kLatticeSweeps && any; ++sweep) {
    any = false;
    for (std::uint32_t body = 0; body < positions.size(); ++body) {
      const auto& range = bodies.problem.bodies[body].variants[leaf.variant[body]].range;
      const auto point = lattice_point_near(positions[body], planes_of(leaf, positions, body, everybody), range);
      if (!point || (point->x == positions[body].x && point->y == positions[body].y)) continue;
      positions[body] = *point;
      any = true;
    }
  }
}

// The lattice points around `at` that keep the lines, or else one near it.
std::vector<RealVec> candidates(RealVec at, std::span<const cells::HalfPlane> planes, const RealBox& range) {
  std::vector<RealVec> points;
  for (const double x : {std::floor(at.x), std::ceil(at.x)}) {
    for (const double y : {std::floor(at.y), std::ceil(at.y)}) {
      const bool inside = x >= range.low_x && x <= range.high_x && y >= range.low_y && y <= range.high_y;
      const auto keeps = [&](const cells::HalfPlane& plane) { return plane.room({x, y}) >= -kKept; };
      if (inside && std::ranges::all_of(planes, keeps)) points.push_back({x, y});
    }
  }
  if (!points.empty()) return points;
  const auto point = lattice_point_near(at, planes, range);
  return point ? std::vector{*point} : points;
}

// Keeps a body at a point; false when the others then have no solution.
bool pinned(Dictionary& program, const Columns& columns, std::uint32_t body, RealVec point) {
  const auto world = static_cast<std::uint32_t>(columns.bodies);
  Dictionary narrower = program;
  narrower.add(columns, {world, body, false, {1, 0, point.x}});
  narrower.add(columns, {world, body, false, {0, 1, point.y}});
  narrower.add(columns, {body, world, false, {1, 0, -point.x}});
  narrower.add(columns, {body, world, false, {0, 1, -point.y}});
  if (!has_solution(narrower, columns)) return false;
  program = std::move(narrower);
  return true;
}

// Bodies go to lattice points one after another, and all that are not on one yet give way: so pieces that touch each
// other in a row between two others share what little room there is.
std::optional<std::vector<RealVec>> one_by_one(const Bodies& bodies, const branching::Leaf& leaf,
                                               const Columns& columns) {
  Dictionary program = program_of(bodies, leaf, columns, {true, false});
  if (!has_solution(program, columns)) return std::nullopt;
  std::vector<RealVec> positions(columns.bodies);
  for (std::uint32_t body = 0; body < columns.bodies; ++body) {
    const auto before = [body](std::uint32_t other) { return other < body; };
    const auto& range = bodies.problem.bodies[body].variants[leaf.variant[body]].range;
    const auto points = candidates(program.position(columns, body), planes_of(leaf, positions, body, before), range);
    const auto point = std::ranges::find_if(points, [&](RealVec p) { return pinned(program, columns, body, p); });
    if (point == points.end()) return std::nullopt;
    positions[body] = *point;
  }
  return positions;
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

bool is_proved(const Marker& marker, const Bodies& bodies, const Freedom& freedom) {
  const marker::PlacedPieces pieces{marker};
  std::vector<std::uint32_t> changed;
  for (const auto& body : bodies.pieces) changed.insert(changed.end(), body.begin(), body.end());
  const auto inside = [&](std::uint32_t piece) { return lies_inside(marker, pieces, piece, freedom); };
  return std::ranges::all_of(changed, inside) && keep_joint_rules(pieces) && are_clear(pieces, changed);
}

}  // namespace

bool place_leaf(const Marker& marker, const Bodies& bodies, const Freedom& freedom, const scene::Run& run,
                branching::Leaf& leaf) {
  const Columns columns = branching::columns_of(bodies.problem);
  const std::vector<RealVec> original = leaf.positions;
  const auto attempt = [&](std::vector<RealVec> positions) {
    leaf.positions = std::move(positions);
    const Marker layout = placed(marker, bodies, leaf);
    const bool proved = is_proved(layout, bodies, freedom);
    if (proved) leaf.length = static_cast<double>(length_of(layout));
    if (!proved) leaf.positions = original;
    return proved;
  };
  if (attempt(leaf.positions)) return true;
  bool has_any = false;
  for (const ProgramKind kind : {ProgramKind{true, true}, {true, false}, {false, true}, {false, false}}) {
    if (run.stopped()) return false;
    const auto positions = solved(bodies, leaf, columns, kind);
    if (!positions) continue;
    has_any = true;
    std::vector<RealVec> whole = snapped_to_lattice(*positions);
    if (attempt(whole) || attempt(*positions)) return true;
    step_on_lattice(bodies, leaf, whole);
    if (attempt(std::move(whole))) return true;
  }
  const auto spacing = static_cast<double>(marker::PlacedPieces{marker}.widest_spacing());
  // Without a spacing, the lines are those of the sums: nothing in these wedges is valid where they have no solution.
  if ((!has_any && spacing == 0) || run.stopped()) return false;
  const auto stepwise = one_by_one(bodies, leaf, columns);
  if (stepwise && attempt(*stepwise)) return true;
  // A spacing's rings leave out a little at corners, so its layouts may overlap by more than rounding.
  const auto without_overlaps = spacing == 0 ? std::nullopt : repaired(placed(marker, bodies, leaf), bodies, leaf, run);
  if (without_overlaps && attempt(*without_overlaps)) return true;
  for (const auto& [part, units] : kRooms) {
    if (run.stopped()) return false;
    const auto positions = with_room(bodies, leaf, columns, part * spacing + units);
    if (positions && attempt(snapped_to_lattice(*positions))) return true;
  }
  return false;
}

}  // namespace selvage::packing::bodies
