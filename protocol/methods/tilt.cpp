// motion.tilt: compaction with small tilts; motion.relax: one piece to where it has most room.
#include <array>
#include <iterator>

#include "core/motion/relax.h"
#include "core/motion/tilt.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"
#include "protocol/methods/motion.h"

namespace selvage {
namespace {

constexpr std::string_view kMethodNames[] = {"linearisation", "relaxation"};  // by TiltMethod
constexpr std::int64_t kMostShakes = 10'000, kMostTilts = 1'001;

// motion.tilt {"method"?, "limit"?, "shakes"?, "tilts"?}
struct MotionTilt {
  MotionCall call;
  TiltSettings settings;
};

Result<MotionTilt> decode_tilt(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionTilt wanted;
  wanted.call = read_call(fields, mistake);
  const Effort effort = read_effort(fields);
  const auto method = static_cast<TiltMethod>(fields.word_or("method", 0, kMethodNames));
  TiltSettings& settings = wanted.settings = tilt_settings(method, effort.accuracy);
  settings.rounds = effort.rounds.value_or(settings.rounds);
  settings.compaction.simplification = effort.simplification.value_or(settings.compaction.simplification);
  if (const auto limit = fields.maybe_number("limit", {0, 45})) settings.limit = Angle::of_degrees(*limit);
  settings.shakes = static_cast<int>(fields.maybe_integer("shakes", 0, kMostShakes).value_or(settings.shakes));
  settings.tilts = static_cast<int>(fields.maybe_integer("tilts", 1, kMostTilts).value_or(settings.tilts));
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<Motion> run_tilt(const MotionTilt& wanted, const Marker& start, const Means& means) {
  auto done = tilt(start, wanted.settings, means.sums, means.stop, means.observer);
  if (!done) return done.error();
  Json figures{{"lengthCompacted", to_decimal(done->length_compacted, start.resolution)},
               {"farthestTilt", done->farthest_tilt.degrees}};
  figures.update(rounds_json(done->rounds, done->reason));
  return Motion{std::move(done->marker), std::move(figures), done->healing};
}

// motion.relax {"piece", "tilts"?}
struct MotionRelax {
  MotionCall call;
  std::string piece;
  int tilts{};  // 0: the piece keeps its tilt
};

Result<MotionRelax> decode_relax(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionRelax wanted;
  wanted.call = read_call(fields, mistake);
  wanted.piece = fields.id("piece");
  wanted.tilts = static_cast<int>(fields.maybe_integer("tilts", 0, kMostTilts).value_or(0));
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<Motion> run_relax(const MotionRelax& wanted, const Marker& start, const Means& means) {
  const auto piece = piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  Scene scene{start, means.sums};
  const auto healing = heal(scene, means.stop, means.observer);
  if (!healing) return healing.error();
  const Marker healed = scene.result();
  const Scene still{healed, means.sums};
  const Relaxation done =
      wanted.tilts > 0 ? relax_tilted(still, piece->value, wanted.tilts) : relax(still, piece->value);
  Motion motion{healed, {}, *healing};
  motion.marker.pieces[piece->value] = done.piece;
  motion.figures = {{"at", point_json(done.piece.at, start.resolution)},
                    {"tilt", done.piece.orientation.tilt.degrees},
                    {"freedom", in_unit(done.freedom, start.resolution)},
                    {"stop", name_of(StopReason::kConverged)}};
  return motion;
}

constexpr std::array kTiltParams = together(
    std::array{
        Word{"method", "'linearisation'|'relaxation'", kOptional,
             "All pieces at once (when absent), or one after another."},
        Word{"limit", "number", kOptional, "Largest tilt in degrees, 0 to 45, in place of every shape's own."},
        Word{"shakes", "integer", kOptional,
             "So often the pieces are shaken for the rounds to begin again, 0 to 10,000."},
        Word{"tilts", "integer", kOptional, "Of relaxation: so many tilts are tried, 1 to 1,001."},
    },
    kEffortParams);
constexpr std::array kTiltResults = together(
    std::array{
        Word{"lengthCompacted", "number", kRequired, "After compaction, before any piece was tilted."},
        Word{"farthestTilt", "number", kRequired, "The largest tilt of any piece either way, in degrees."},
    },
    kRoundsResults);
constexpr std::array kRelaxParams{
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"tilts", "integer", kOptional, "So many tilts are tried; 0, as when absent: it keeps its tilt."},
};
constexpr std::array kRelaxResults = together(
    std::array{
        Word{"at", "Point", kRequired, "Where it lies now."},
        Word{"tilt", "number", kRequired, "How it is tilted now, in degrees."},
        Word{"freedom", "number", kRequired, "It may move by so much along both axes at once, either way."},
    },
    kStopResults);

constexpr std::array kMethods{MarkerMethod{"motion.tilt",
                                           MethodKind::kMove,
                                           &read_motion<decode_tilt, run_tilt>,
                                           {"The marker made shorter with small tilts.", kTiltParams, kTiltResults}},
                              MarkerMethod{"motion.relax",
                                           MethodKind::kStep,
                                           &read_motion<decode_relax, run_relax>,
                                           {"One piece goes to where it has most room.", kRelaxParams, kRelaxResults}}};

}  // namespace

std::span<const MarkerMethod> tilting_methods() {
  return kMethods;
}

}  // namespace selvage
