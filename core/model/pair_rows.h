// The rows that keep two pieces apart: one for each half-plane of a free region of their relative position
// [Li94 4.1.3]. Every program makes its rows here.  Units: lattice units, but for the tolerance of solvers, which is in
// column units.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "core/geometry/real_plane.h"
#include "core/marker/placed_pieces.h"
#include "core/model/free_region.h"
#include "core/model/model_unit.h"

namespace selvage::model {

// normal . (displacement of pair.second - displacement of pair.first) >= bound, with the unit normal (nx, ny).
struct PairRow {
  marker::PiecePair pair;
  double nx{}, ny{};
  double bound{};
};
// What a row says about a displacement of the second piece against the first: normal . by.
[[nodiscard]] inline double along(const PairRow& row, RealVec by) {
  return row.nx * by.x + row.ny * by.y;
}

// What a row requires of a pair that has less room than the row's margin.
enum class TightRows {
  kRestore,  // to regain the margin: one or two lattice units, which the length or a gap elsewhere can spare
  kKeep,     // to keep the room that it has: for layouts without any slack, where kRestore is infeasible
};

// How two pieces lie relative to each other.
struct PairPosition {
  const minkowski::Obstacle& obstacle;  // that the first piece is to the second
  Vec r;                                // where the second is now, relative to the first
  Vec about;        // the relative position that the free region is chosen about: r, or, for pieces that overlap, a
                    // position just outside their sum.  With a negative spacing r will do for those, too
  Coord spacing{};  // the least signed distance that the rows keep
};

// A half-plane of a free region, seen from the present relative position.
struct FreeSide {
  HalfPlane line;
  RealVec normal;  // unit; points out of the sum
  double slack{};  // how far the second piece can move against the normal, the spacing kept; negative: it is too close
  bool may_overlap{};  // the spacing is negative
  [[nodiscard]] bool slanted() const { return line.direction.x != 0 && line.direction.y != 0; }
};
[[nodiscard]] FreeSide side_at(const HalfPlane& line, Vec r, Coord spacing);

// The greedy region that looks at edges which come within `reach` of taking the pair's spacing.
[[nodiscard]] inline RegionSettings region_within(double reach, Coord spacing, RealVec towards = {}) {
  const Coord apart = std::max(spacing, Coord{0});
  return {RegionRule::kGreedy, reach + static_cast<double>(apart), apart, towards, {}};
}

// The half-planes of the pair's free region, to be moved outwards by the spacing: overlap_region when it is negative.
[[nodiscard]] std::vector<HalfPlane> region_of(const PairPosition& position, const RegionSettings& region);
// The sides of the free region.
[[nodiscard]] std::vector<FreeSide> free_sides(const PairPosition& position, const RegionSettings& region);

// The row that keeps the second piece inside a side.  A slanted row has a margin that covers the rounding of
// displacements to the lattice and the tolerance of solvers; rows along the axes need none (core/model/snap.h).  For a
// pair that may overlap it also covers the rounding of the translation that proves the overlap to be allowed.
[[nodiscard]] PairRow row_of(marker::PiecePair pair, const FreeSide& side, ModelUnit unit, TightRows tight);

struct RowSettings {
  ModelUnit unit;
  TightRows tight{};
  // Rows that the pair cannot break while its pieces move against each other by no more than this on each axis are left
  // out.
  double motion{std::numeric_limits<double>::infinity()};
};
// The rows of one pair.
[[nodiscard]] std::vector<PairRow> pair_rows(marker::PiecePair pair, const PairPosition& position,
                                             const RegionSettings& region, const RowSettings& settings);
// The same, appended to `rows`.
void append_pair_rows(marker::PiecePair pair, const PairPosition& position, const RegionSettings& region,
                      const RowSettings& settings, std::vector<PairRow>& rows);

}  // namespace selvage::model
