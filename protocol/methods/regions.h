// What marker.regions and motion.openGap share: what counts as an unoccupied region, and how one is told.
#pragma once

#include <optional>

#include "core/marker/unoccupied.h"
#include "protocol/fields.h"
#include "protocol/methods/words.h"

namespace selvage {

inline constexpr Range kRegionSizes{0, 1e18};

// {"leastArea"?, "clearance"?}, in the marker's unit and its square; absent: unoccupied_settings().
struct RegionWish {
  std::optional<double> least_area, clearance;
};
[[nodiscard]] RegionWish read_region_wish(Fields& fields);
[[nodiscard]] UnoccupiedSettings settings_of(const RegionWish& wish, const Marker& marker);

inline constexpr std::array kRegionParams{
    Word{"leastArea", "number", kOptional, "Smaller regions are left out; 1e-4 of the width squared when absent."},
    Word{"clearance", "number", kOptional, "How far regions stay from pieces; 2e-3 of the width when absent."}};

// A square measure in the marker's unit.
[[nodiscard]] double area_in_unit(double lattice, Resolution resolution);
// {"outline", "holes", "area", "around": [piece ids]}
[[nodiscard]] Json region_json(const Marker& marker, const UnoccupiedRegion& region);

}  // namespace selvage
