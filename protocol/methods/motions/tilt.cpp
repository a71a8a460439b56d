// motion.tilt: compaction with small tilts [Li94 6].
#include <cmath>

#include "core/motion/tilting/tilt.h"
#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr double kMostTilt = 45, kMostRestarts = 10'000, kMostTilts = 1'001;

struct TiltParams {
  calls::CommonParams call;
  calls::Effort effort;
  motion::tilting::TiltMethod method{};
  std::optional<double> limit;
  std::optional<int> restarts, tilts;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.part(self.effort);
    v.optional("method", self.method, "All pieces at once (when absent), or one after another.");
    v.optional("limit", self.limit, "Largest tilt in degrees, 0 to 45; replaces the limit of every shape.",
               {.range = {{0, kMostTilt}}});
    v.optional("restarts", self.restarts,
               "Number of random restarts: how many times the pieces are perturbed and the rounds begin again, 0 to "
               "10,000.",
               {.range = {{0, kMostRestarts}}});
    v.optional("tilts", self.tilts, "Only for relaxation: number of tilt angles sampled, 1 to 1,001.",
               {.range = {{1, kMostTilts}}});
  }
};

struct TiltResult {
  double length_compacted{}, farthest_tilt{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("lengthCompacted", self.length_compacted, "The length after compaction, before any piece was tilted.");
    v.required("farthestTilt", self.farthest_tilt, "The largest absolute tilt of any piece, in degrees.");
    v.part(self.rounds);
  }
};

motion::tilting::TiltSettings settings_of(const TiltParams& params) {
  motion::tilting::TiltSettings settings = tilt_settings(params.method, params.effort.accuracy);
  settings.rounds = params.effort.rounds.value_or(settings.rounds);
  settings.compaction.simplification = params.effort.simplification.value_or(settings.compaction.simplification);
  if (params.limit) settings.limit = Angle::of_degrees(*params.limit);
  settings.perturbations = params.restarts.value_or(settings.perturbations);
  settings.tilts = params.tilts.value_or(settings.tilts);
  return settings;
}

Result<calls::Motion<TiltResult>> run_tilt(const TiltParams& params, const Marker& start,
                                           const calls::MethodContext& context) {
  auto done = tilt(start, settings_of(params), context.run);
  if (!done) return done.error();
  const TiltResult result{
      .length_compacted = to_decimal(done->length_compacted, start.resolution),
      .farthest_tilt = std::round(done->farthest_tilt.degrees * 1e9) / 1e9,  // without the noise of angles
      .rounds = {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<TiltResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method tilt_method() {
  return calls::motion_method("motion.tilt", calls::MethodKind::kMotion, "Shortens the marker with small tilts.",
                              run_tilt);
}

}  // namespace selvage::protocol::methods::motions
