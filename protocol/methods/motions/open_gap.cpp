// motion.openGap: the pieces around an unoccupied region move away from it, at fixed length [Li94 4.2.2].
#include "core/motion/compaction/open_gap.h"

#include "protocol/calls/motion.h"
#include "protocol/methods/readings/regions.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr double kMostRegions = 1'000'000;

struct OpenGapParams {
  calls::CommonParams call;
  calls::Effort effort;
  readings::RegionLimits regions;
  std::optional<std::size_t> region;
  std::optional<calls::Point> point;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.part(self.effort);
    v.part(self.regions);
    v.optional("region", self.region,
               "The index of a region in the list of marker.regions, from 0: pieces move away from its outline.",
               {.range = {{0, kMostRegions}}});
    v.optional("point", self.point,
               "A point in an unoccupied region: the pieces around it move away from the point. Required without a "
               "region.");
    v.check([](const json::Fields& fields, json::Mistake& mistake) {
      if (fields.has("region") && fields.has("point")) {
        mistake.add(ErrorCode::kUnknownField, "a point and a region are both given; one of them is required",
                    fields.pointer("point"));
      } else if (!fields.has("region") && !fields.has("point")) {
        mistake.add(ErrorCode::kMissingField, "the field is missing; it is required", fields.pointer("point"));
      }
    });
  }
};

struct OpenGapResult {
  double area_before{}, area_after{};
  calls::Point inside;
  readings::Region gap;
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("areaBefore", self.area_before, "The area of the region that contains the point inside.");
    v.required("areaAfter", self.area_after, "Its area after the motion; never smaller.");
    v.required("inside", self.inside, "A point of the gap, before and after.");
    v.required("gap", self.gap, "The region after the motion.");
    v.part(self.rounds);
  }
};

Result<motion::compaction::GapChoice> choice_of(const OpenGapParams& params, Resolution resolution) {
  if (params.region) return motion::compaction::GapChoice{motion::compaction::AwayFromOutline{*params.region}};
  const auto point = calls::place_on_lattice(*params.point, resolution, "/point");
  if (!point) return point.error();
  return motion::compaction::GapChoice{motion::compaction::AwayFromPoint{*point}};
}

Result<calls::Motion<OpenGapResult>> run_open_gap(const OpenGapParams& params, const Marker& start,
                                                  const calls::MethodContext& context) {
  const auto choice = choice_of(params, start.resolution);
  if (!choice) return choice.error();
  auto done = open_gap(start, *choice, settings_of(params.effort), settings_of(params.regions, start), context.run);
  if (!done) return done.error();
  OpenGapResult result{.area_before = readings::area_in_unit(done->before.area, start.resolution),
                       .area_after = readings::area_in_unit(done->after.area, start.resolution),
                       .inside = calls::point_of(done->inside, start.resolution),
                       .gap = readings::region_of(done->marker, done->after),
                       .rounds = {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<OpenGapResult>{{std::move(done->marker), done->repair}, std::move(result)};
}

}  // namespace

calls::Method open_gap_method() {
  return calls::motion_method("motion.openGap", calls::MethodKind::kMotion,
                              "Moves pieces away from a point or an unoccupied region, at fixed length.", run_open_gap);
}

}  // namespace selvage::protocol::methods::motions
