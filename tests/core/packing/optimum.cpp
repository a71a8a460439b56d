#include "tests/core/packing/optimum.h"

#include <gtest/gtest.h>

#include "core/marker/validity.h"

namespace selvage::test {

packing::Packing packed(const Marker& marker, const packing::PackSettings& settings) {
  SumCache sums;
  packing::Packing packing = pack(marker, settings, {sums});
  EXPECT_EQ(packing.length_after, length_of(packing.marker));
  if (packing.found) {
    EXPECT_LE(packing.bound, packing.length_after);
    EXPECT_TRUE(is_valid(packing.marker));
  }
  return packing;
}

void expect_optimum(const Marker& marker, Coord optimum, const packing::PackSettings& settings) {
  const packing::Packing packing = packed(marker, settings);
  EXPECT_TRUE(packing.proved);
  EXPECT_EQ(packing.reason, scene::StopReason::kConverged);
  EXPECT_LE(packing.bound, optimum);
  EXPECT_GE(packing.length_after, optimum);
  EXPECT_LE(packing.length_after, optimum + 16);
}

}  // namespace selvage::test
