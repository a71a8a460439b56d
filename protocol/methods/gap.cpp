// motion.openGap: the pieces around an unoccupied region move away from it, the length held.
#include <array>

#include "core/motion/open_gap.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"
#include "protocol/methods/motion.h"
#include "protocol/methods/places.h"
#include "protocol/methods/regions.h"

namespace selvage {
namespace {

constexpr std::int64_t kMostRegions = 1'000'000;

// motion.openGap {"point" or "region", "leastArea"?, "clearance"?}
struct MotionOpenGap {
  MotionCall call;
  Effort effort;
  RegionWish wish;
  std::optional<Decimal> point;
  std::optional<std::size_t> region;
};

Result<MotionOpenGap> decode(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionOpenGap wanted;
  wanted.call = read_call(fields, mistake);
  wanted.effort = read_effort(fields);
  wanted.wish = read_region_wish(fields);
  if (fields.has("region")) {
    wanted.region = static_cast<std::size_t>(fields.maybe_integer("region", 0, kMostRegions).value_or(0));
    if (fields.has("point")) {
      mistake.add(ErrorCode::kUnknownField, "a point and a region are one too many; either is allowed",
                  fields.pointer("point"));
    }
  } else {
    wanted.point = read_place(fields, "point", mistake);
  }
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<GapChoice> choice_of(const MotionOpenGap& wanted, Resolution resolution) {
  if (wanted.region) return GapChoice{AwayFromOutline{*wanted.region}};
  const auto point = place_on_lattice(*wanted.point, resolution, "/point");
  if (!point) return point.error();
  return GapChoice{AwayFromPoint{*point}};
}

Result<Motion> run(const MotionOpenGap& wanted, const Marker& start, const Means& means) {
  const auto choice = choice_of(wanted, start.resolution);
  if (!choice) return choice.error();
  auto done = open_gap(start, *choice, settings_of(wanted.effort), settings_of(wanted.wish, start), means.sums,
                       means.stop, means.observer);
  if (!done) return done.error();
  Json figures{{"areaBefore", area_in_unit(done->before.area, start.resolution)},
               {"areaAfter", area_in_unit(done->after.area, start.resolution)},
               {"inside", point_json(done->inside, start.resolution)},
               {"gap", region_json(done->marker, done->after)}};
  figures.update(rounds_json(done->rounds, done->reason));
  return Motion{std::move(done->marker), std::move(figures), done->healing};
}

constexpr std::array kParams = together(
    std::array{
        Word{"point", "Point", kOptional,
             "In an unoccupied region: pieces around it move away from the point. Required without a region."},
        Word{"region", "integer", kOptional,
             "A region's place in the list of marker.regions, from 0: pieces move away from its outline."},
    },
    kRegionParams, kEffortParams);
constexpr std::array kResults = together(
    std::array{
        Word{"areaBefore", "number", kRequired, "Of the region that holds the point inside."},
        Word{"areaAfter", "number", kRequired, "Never smaller."},
        Word{"inside", "Point", kRequired, "A point of the gap, before and after."},
        Word{"gap", "Region", kRequired, "The region afterwards."},
    },
    kRoundsResults);

constexpr std::array kMethods{
    MarkerMethod{"motion.openGap",
                 MethodKind::kMove,
                 &read_motion<decode, run>,
                 {"Pieces move away from a point or an unoccupied region, the length held.", kParams, kResults}}};

}  // namespace

std::span<const MarkerMethod> gap_methods() {
  return kMethods;
}

}  // namespace selvage
