// What marker.regions and motion.openGap share: what counts as an unoccupied region, and how one is told.
#pragma once

#include <optional>

#include "core/marker/unoccupied.h"
#include "protocol/calls/words.h"
#include "protocol/json/fields.h"

namespace selvage::protocol::methods::readings {

inline constexpr json::Range kRegionSizes{0, 1e18};

// {"leastArea"?, "clearance"?}, in the marker's unit and its square; absent: unoccupied_settings().
struct RegionWish {
  std::optional<double> least_area, clearance;
};
[[nodiscard]] RegionWish read_region_wish(json::Fields& fields);
[[nodiscard]] marker::UnoccupiedSettings settings_of(const RegionWish& wish, const Marker& marker);

inline constexpr std::array kRegionParams{
    calls::Word{"leastArea", "number", calls::kOptional,
                "Smaller regions are left out; 1e-4 of the width squared when absent."},
    calls::Word{"clearance", "number", calls::kOptional,
                "How far regions stay from pieces; 2e-3 of the width when absent."}};

// A square measure in the marker's unit.
[[nodiscard]] double area_in_unit(double lattice, Resolution resolution);
// {"outline", "holes", "area", "around": [piece ids]}
[[nodiscard]] Json region_json(const Marker& marker, const marker::UnoccupiedRegion& region);

}  // namespace selvage::protocol::methods::readings
