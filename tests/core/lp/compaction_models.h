// Linear programs with the structure of a compaction step, made from points instead of pieces.
//
// The points lie on a jittered grid across a strip 1000 wide.  The columns are the displacements of the points and,
// last, the change of the strip's length.  Rows normal . (dq - dp) >= -slack, with several unit normals per pair, keep
// neighbours apart; the strip's walls are column bounds; and every point stays within the length.  x = 0 is feasible.
#pragma once

#include <cstdint>

#include "core/lp/linear_program.h"

namespace selvage::lp {

struct CompactionModel {
  int points{};
  int across{10};        // points across the strip
  int normals{4};        // rows per pair of neighbours
  double tight{0.2};     // the fraction of rows without slack
  double gravity{1e-4};  // the weight of the mean leftward motion
  std::uint64_t seed{1};
};

[[nodiscard]] LinearProgram compaction_program(const CompactionModel& model);

}  // namespace selvage::lp
