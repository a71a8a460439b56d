// Linear programs shaped like those of a compaction, made from points instead of pieces.
//
// Points lie on a jittered grid across a strip 1000 wide.  Columns are their displacements and, last, the change of the
// strip's length; neighbours are held apart by rows normal . (dq - dp) >= -slack with several unit normals a pair, the
// strip's walls are column bounds, and every point's right end keeps within the length.  x = 0 is feasible.
#pragma once

#include <cstdint>

#include "core/lp/linear_program.h"

namespace selvage::lp {

struct CompactionModel {
  int points{};
  int across{10};        // points across the strip
  int normals{4};        // rows a pair of neighbours
  double tight{0.2};     // the part of the rows with no slack at all
  double gravity{1e-4};  // weight of the mean leftward motion
  std::uint64_t seed{1};
};

[[nodiscard]] LinearProgram compaction_program(const CompactionModel& model);

}  // namespace selvage::lp
