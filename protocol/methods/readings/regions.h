// What marker.regions and motion.openGap share: the definition of an unoccupied region and its description.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/marker/unoccupied.h"
#include "protocol/calls/values.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::methods::readings {

// In the marker's unit and its square; those of unoccupied_settings() if absent.
struct RegionLimits {
  std::optional<double> least_area, clearance;

  static constexpr schema::Limits kSizes{.range = {{0, 1e18}}};
  static void describe(auto& v, auto& self) {
    v.optional("leastArea", self.least_area, "Smaller regions are omitted; 1e-4 of the width squared when absent.",
               kSizes);
    v.optional("clearance", self.clearance,
               "The distance that regions keep from pieces; 2e-3 of the width when absent.", kSizes);
  }
};
[[nodiscard]] marker::UnoccupiedSettings settings_of(const RegionLimits& limits, const Marker& marker);

struct Region {
  static constexpr std::string_view kName = "Region", kMeaning = "Cloth that no piece covers; its corners are rounded.";
  std::vector<calls::Point> outline;
  std::vector<std::vector<calls::Point>> holes;
  double area{};
  std::vector<std::string> around;

  static void describe(auto& v, auto& self) {
    v.required("outline", self.outline, "Counter-clockwise.");
    v.required("holes", self.holes, "The outlines of its holes.");
    v.required("area", self.area, "Its area without the holes.");
    v.required("around", self.around, "Ids of the adjacent pieces.");
  }
};
[[nodiscard]] Region region_of(const Marker& marker, const marker::UnoccupiedRegion& region);

// An area of the lattice in the square of the marker's unit.
[[nodiscard]] double area_in_unit(double lattice, Resolution resolution);

}  // namespace selvage::protocol::methods::readings
