// What must hold for every compaction, tested on random markers.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "tests/core/motion/markers.h"

namespace selvage::motion {
namespace {

Marker random_marker() {
  const auto seed = *rc::gen::arbitrary<std::uint32_t>();
  const int columns = *rc::gen::inRange(1, 6);
  const int rows = *rc::gen::inRange(1, 4);
  const Coord radius = *rc::gen::element<Coord>(20, 1'000, 100'000, 10'000'000, 10'000'000'000);
  Marker marker = test::loose_marker(seed, columns, rows, 1000);
  // The same marker at another scale: the smallest scales show rounding, the largest ones overflow of products.
  const auto scaled = [&](Coord c) { return c * radius / 1000; };
  for (Shape& shape : marker.shapes) {
    for (Vec& v : shape.outline) v = {scaled(v.x), scaled(v.y)};
    auto clean = clean_polygon(shape.outline);
    RC_PRE(static_cast<bool>(clean));
    shape.outline = clean->polygon;
  }
  for (Piece& piece : marker.pieces) piece.at = {scaled(piece.at.x + 40), scaled(piece.at.y + 40)};
  marker.strip.width = scaled(marker.strip.width + 100);
  RC_PRE(is_valid(marker));
  return marker;
}

RC_GTEST_PROP(CompactLaws, ValidNeverLongerLocksHold, ()) {
  Marker marker = random_marker();
  const auto every = *rc::gen::inRange<std::size_t>(2, 9);
  for (std::size_t k = 0; k < marker.pieces.size(); k += every) marker.pieces[k].locked = k % 2 == 1;
  compaction::CompactionSettings settings = compaction_settings(
      *rc::gen::element(compaction::Accuracy::kDraft, compaction::Accuracy::kStandard, compaction::Accuracy::kFine));
  settings.region = *rc::gen::element(model::RegionRule::kGreedy, model::RegionRule::kWalk);
  settings.solver = *rc::gen::element(lp::solver::SolverChoice::kAutomatic, lp::solver::SolverChoice::kSimplex);
  settings.trust = *rc::gen::element(0.01, 0.1, 1.0);
  SumCache sums;
  const auto result = compact(marker, settings, {sums});
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
  RC_ASSERT(result->repair.pairs == 0U);
  for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
    if (marker.pieces[k].locked) RC_ASSERT(result->marker.pieces[k].at == marker.pieces[k].at);
    RC_ASSERT(result->marker.pieces[k].orientation == marker.pieces[k].orientation);
  }
  RC_ASSERT(result->marker.shapes == marker.shapes);
}

RC_GTEST_PROP(CompactLaws, SpacingHolds, ()) {
  Marker marker = random_marker();
  marker.spacing = marker.strip.width / *rc::gen::inRange<Coord>(1000, 5000) + 1;
  RC_PRE(is_valid(marker));
  SumCache sums;
  const auto result = compact(marker, compaction_settings(compaction::Accuracy::kStandard), {sums});
  RC_ASSERT(static_cast<bool>(result));
  RC_ASSERT(is_valid(result->marker));
  RC_ASSERT(result->length_after <= result->length_before);
}

}  // namespace
}  // namespace selvage::motion
