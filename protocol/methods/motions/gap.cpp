// motion.openGap: the pieces around an unoccupied region move away from it, the length held.
#include <array>

#include "core/motion/compaction/open_gap.h"
#include "protocol/calls/motion.h"
#include "protocol/calls/places.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"
#include "protocol/methods/readings/regions.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr std::int64_t kMostRegions = 1'000'000;

// motion.openGap {"point" or "region", "leastArea"?, "clearance"?}
struct MotionOpenGap {
  calls::MotionCall call;
  calls::Effort effort;
  readings::RegionWish wish;
  std::optional<formats::Decimal> point;
  std::optional<std::size_t> region;
};

Result<MotionOpenGap> decode(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionOpenGap wanted;
  wanted.call = calls::read_call(fields, mistake);
  wanted.effort = calls::read_effort(fields);
  wanted.wish = readings::read_region_wish(fields);
  if (fields.has("region")) {
    wanted.region = static_cast<std::size_t>(fields.maybe_integer("region", 0, kMostRegions).value_or(0));
    if (fields.has("point")) {
      mistake.add(ErrorCode::kUnknownField, "a point and a region are one too many; either is allowed",
                  fields.pointer("point"));
    }
  } else {
    wanted.point = calls::read_place(fields, "point", mistake);
  }
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<motion::compaction::GapChoice> choice_of(const MotionOpenGap& wanted, Resolution resolution) {
  if (wanted.region) return motion::compaction::GapChoice{motion::compaction::AwayFromOutline{*wanted.region}};
  const auto point = calls::place_on_lattice(*wanted.point, resolution, "/point");
  if (!point) return point.error();
  return motion::compaction::GapChoice{motion::compaction::AwayFromPoint{*point}};
}

Result<calls::Motion> run(const MotionOpenGap& wanted, const Marker& start, const calls::MethodContext& context) {
  const auto choice = choice_of(wanted, start.resolution);
  if (!choice) return choice.error();
  auto done = open_gap(start, *choice, settings_of(wanted.effort), settings_of(wanted.wish, start), context.run);
  if (!done) return done.error();
  Json figures{{"areaBefore", readings::area_in_unit(done->before.area, start.resolution)},
               {"areaAfter", readings::area_in_unit(done->after.area, start.resolution)},
               {"inside", formats::point_json(done->inside, start.resolution)},
               {"gap", readings::region_json(done->marker, done->after)}};
  figures.update(calls::rounds_json(done->rounds, done->reason));
  return calls::Motion{std::move(done->marker), std::move(figures), done->repair};
}

constexpr std::array kParams = together(
    std::array{
        calls::Word{"point", "Point", calls::kOptional,
                    "In an unoccupied region: pieces around it move away from the point. Required without a region."},
        calls::Word{"region", "integer", calls::kOptional,
                    "A region's place in the list of marker.regions, from 0: pieces move away from its outline."},
    },
    readings::kRegionParams, calls::kEffortParams);
constexpr std::array kResults = together(
    std::array{
        calls::Word{"areaBefore", "number", calls::kRequired, "Of the region that holds the point inside."},
        calls::Word{"areaAfter", "number", calls::kRequired, "Never smaller."},
        calls::Word{"inside", "Point", calls::kRequired, "A point of the gap, before and after."},
        calls::Word{"gap", "Region", calls::kRequired, "The region afterwards."},
    },
    calls::kRoundsResults);

constexpr std::array kMethods{calls::MarkerMethod{
    "motion.openGap",
    calls::MethodKind::kMove,
    &calls::read_motion<decode, run>,
    {"Pieces move away from a point or an unoccupied region, the length held.", kParams, kResults}}};

}  // namespace

std::span<const calls::MarkerMethod> gap_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
