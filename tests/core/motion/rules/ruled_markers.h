// Markers whose pieces have rules of their own, and functions that query them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/compaction/critical_path.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion::test_rules {

using compaction::Rule;
using test::Layout;

inline constexpr Coord kSide = 100'000;

// Squares in a strip ten times as wide as one.
inline Marker squares(const std::vector<Vec>& places) {
  Layout layout{10 * kSide};
  const auto square = layout.shape_of(test::rectangle(kSide, kSide));
  for (const Vec at : places) layout.put(square, at);
  return layout.marker();
}

inline Marker compacted(const Marker& marker) {
  SumCache sums;
  auto done = compact(marker, compaction::compaction_settings(compaction::Accuracy::kFine), {sums});
  EXPECT_TRUE(done) << done.error().message;
  EXPECT_TRUE(is_valid(done->marker));
  return done->marker;
}

inline compaction::CriticalPath held(const Marker& marker) {
  SumCache sums;
  auto path = compaction::critical_path(marker, {sums});
  EXPECT_TRUE(path) << path.error().message;
  return *path;
}

// The price of a piece's rule, per unit; 0 when the rule has no effect on the length.
inline double worth_of(const compaction::CriticalPath& path, Rule rule, std::optional<PieceId> piece) {
  const auto price = std::find_if(path.rules.begin(), path.rules.end(), [&](const compaction::RulePrice& one) {
    return one.rule == rule && one.piece == piece;
  });
  return price == path.rules.end() ? 0 : price->worth;
}

}  // namespace selvage::motion::test_rules
