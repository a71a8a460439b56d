// marker.regions: the cloth that no piece covers.
#include "protocol/methods/readings/regions.h"

#include <algorithm>
#include <array>

#include "protocol/calls/call_fields.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/readings/families.h"
#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::readings {
namespace {

// marker.regions {"markerId", "leastArea"?, "clearance"?, "deadlineMs"?}
struct MarkerRegions {
  std::string marker_id;
  RegionWish wish;
  std::optional<double> deadline_ms;  // the server's business
};

Result<MarkerRegions> decode(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MarkerRegions wanted{fields.text("markerId"), read_region_wish(fields), calls::read_deadline(fields)};
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<calls::MethodAnswer> run(const MarkerRegions& wanted, const MarkerFile& file,
                                const calls::MethodContext& context) {
  const auto regions = unoccupied_regions(file.marker, settings_of(wanted.wish, file.marker), context.run.stop);
  if (!regions) return regions.error();
  Json list = Json::array();
  for (const marker::UnoccupiedRegion& region : *regions) {
    list.push_back(region_json(file.marker, region));
  }
  return calls::MethodAnswer{{{"regions", std::move(list)}}, std::nullopt};
}

constexpr std::array kResults{
    calls::Word{"regions", "Region[]", calls::kRequired, "From left to right."},
};

constexpr std::array kMethods{calls::MarkerMethod{"marker.regions",
                                                  calls::MethodKind::kStudy,
                                                  &read_reading<decode, run>,
                                                  {"The cloth that no piece covers.", kRegionParams, kResults}}};

}  // namespace

RegionWish read_region_wish(json::Fields& fields) {
  return {fields.maybe_number("leastArea", kRegionSizes), fields.maybe_number("clearance", kRegionSizes)};
}

marker::UnoccupiedSettings settings_of(const RegionWish& wish, const Marker& marker) {
  marker::UnoccupiedSettings settings = unoccupied_settings(marker.strip);
  const double width = to_decimal(marker.strip.width, marker.resolution);
  if (wish.least_area) settings.least_area = *wish.least_area / (width * width);
  if (wish.clearance)
    settings.clearance = formats::spacing_on_lattice(std::min(*wish.clearance, width), marker.resolution);
  return settings;
}

double area_in_unit(double lattice, Resolution resolution) {
  return formats::in_unit(formats::in_unit(lattice, resolution), resolution);
}

Json region_json(const Marker& marker, const marker::UnoccupiedRegion& region) {
  Json holes = Json::array();
  for (const Polygon& hole : region.region.holes) holes.push_back(formats::outline_json(hole, marker.resolution));
  Json around = Json::array();
  for (const marker::Bordering& beside : region.around) around.push_back(marker.pieces[beside.piece.value].id);
  return {{"outline", formats::outline_json(region.region.outline, marker.resolution)},
          {"holes", std::move(holes)},
          {"area", area_in_unit(region.area, marker.resolution)},
          {"around", std::move(around)}};
}

std::span<const calls::MarkerMethod> region_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::readings
