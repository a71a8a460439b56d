// marker.regions: the cloth that no piece covers.
#include "protocol/methods/readings/regions.h"

#include <algorithm>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::readings {
namespace {

struct RegionsParams {
  std::string marker_id;
  RegionLimits regions;
  std::optional<double> deadline_ms;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.part(self.regions);
    v.optional("deadlineMs", self.deadline_ms, calls::kReadDeadlineMeaning, calls::kDeadlines);
  }
};

struct RegionsResult {
  std::vector<Region> regions;

  static void describe(auto& v, auto& self) { v.required("regions", self.regions, "The regions, from left to right."); }
};

std::vector<calls::Point> points_of(const Polygon& outline, Resolution resolution) {
  std::vector<calls::Point> points;
  for (const Vec vertex : outline) points.push_back(calls::point_of(vertex, resolution));
  return points;
}

Result<RegionsResult> run_regions(const RegionsParams& params, const MarkerFile& file,
                                  const calls::MethodContext& context) {
  const auto regions = unoccupied_regions(file.marker, settings_of(params.regions, file.marker), context.run.stop);
  if (!regions) return regions.error();
  RegionsResult result;
  for (const marker::UnoccupiedRegion& region : *regions) result.regions.push_back(region_of(file.marker, region));
  return result;
}

}  // namespace

marker::UnoccupiedSettings settings_of(const RegionLimits& limits, const Marker& marker) {
  marker::UnoccupiedSettings settings = unoccupied_settings(marker.strip);
  const double width = to_decimal(marker.strip.width, marker.resolution);
  if (limits.least_area) settings.least_area = *limits.least_area / (width * width);
  if (limits.clearance)
    settings.clearance = formats::spacing_on_lattice(std::min(*limits.clearance, width), marker.resolution);
  return settings;
}

double area_in_unit(double lattice, Resolution resolution) {
  return formats::in_unit(formats::in_unit(lattice, resolution), resolution);
}

Region region_of(const Marker& marker, const marker::UnoccupiedRegion& region) {
  Region named{.outline = points_of(region.region.outline, marker.resolution),
               .holes = {},
               .area = area_in_unit(region.area, marker.resolution),
               .around = {}};
  for (const Polygon& hole : region.region.holes) named.holes.push_back(points_of(hole, marker.resolution));
  for (const marker::Bordering& beside : region.around) named.around.push_back(marker.pieces[beside.piece.value].id);
  return named;
}

calls::Method regions_method() {
  return reading_method("marker.regions", calls::MethodKind::kAnalysis,
                        "The regions of the cloth that no piece covers.", run_regions);
}

}  // namespace selvage::protocol::methods::readings
