// A minimal program that uses the core: it compacts three pieces on a strip with one call; every position is proved.
#include <cstdio>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"

int main() {
  using namespace selvage;  // NOLINT(google-build-using-namespace)
  Marker marker;
  marker.resolution = {-3};        // one lattice unit is 0.001 mm
  marker.strip.width = 1'000'000;  // 1 m across

  Shape wedge;
  wedge.id = "wedge";
  wedge.outline = {{0, 0}, {600'000, 0}, {0, 500'000}};
  wedge.rotations = {Angle::of_degrees(0), Angle::of_degrees(180)};
  marker.shapes.push_back(wedge);

  marker.pieces = {{"a", ShapeId{0}, {}, {0, 0}, false},
                   {"b", ShapeId{0}, {false, Angle::of_degrees(180), {}}, {900'000, 700'000}, false},
                   {"c", ShapeId{0}, {}, {950'000, 300'000}, false}};

  const auto checked = make_marker(marker);
  if (!checked) return std::puts(checked.error().message.c_str()), 1;
  SumCache sums;
  const auto result = compact(*checked, compaction_settings(selvage::motion::compaction::Accuracy::kStandard), {sums});
  if (!result) return std::puts(result.error().message.c_str()), 1;
  const auto in_mm = [&](Coord c) { return to_decimal(c, marker.resolution); };
  std::printf("%g mm -> %g mm in %d rounds, %s\n", in_mm(result->length_before), in_mm(result->length_after),
              result->rounds, is_valid(result->marker) ? "valid" : "not valid");
  for (const Piece& piece : result->marker.pieces) {
    std::printf("  %s at (%g, %g)\n", piece.id.c_str(), in_mm(piece.at.x), in_mm(piece.at.y));
  }
}
