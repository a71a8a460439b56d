// motion.tilt: compaction with small tilts; motion.relax: one piece to where it has most room.
#include <array>
#include <iterator>

#include "core/motion/piece/relax.h"
#include "core/motion/tilting/tilt.h"
#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr std::string_view kMethodNames[] = {"linearisation", "relaxation"};  // by TiltMethod
constexpr std::int64_t kMostShakes = 10'000, kMostTilts = 1'001;

// motion.tilt {"method"?, "limit"?, "shakes"?, "tilts"?}
struct MotionTilt {
  calls::MotionCall call;
  motion::tilting::TiltSettings settings;
};

Result<MotionTilt> decode_tilt(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionTilt wanted;
  wanted.call = calls::read_call(fields, mistake);
  const calls::Effort effort = calls::read_effort(fields);
  const auto method = static_cast<motion::tilting::TiltMethod>(fields.word_or("method", 0, kMethodNames));
  motion::tilting::TiltSettings& settings = wanted.settings = tilt_settings(method, effort.accuracy);
  settings.rounds = effort.rounds.value_or(settings.rounds);
  settings.compaction.simplification = effort.simplification.value_or(settings.compaction.simplification);
  if (const auto limit = fields.maybe_number("limit", {0, 45})) settings.limit = Angle::of_degrees(*limit);
  settings.perturbations =
      static_cast<int>(fields.maybe_integer("shakes", 0, kMostShakes).value_or(settings.perturbations));
  settings.tilts = static_cast<int>(fields.maybe_integer("tilts", 1, kMostTilts).value_or(settings.tilts));
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<calls::Motion> run_tilt(const MotionTilt& wanted, const Marker& start, const calls::MethodContext& context) {
  auto done = tilt(start, wanted.settings, context.run);
  if (!done) return done.error();
  Json figures{{"lengthCompacted", to_decimal(done->length_compacted, start.resolution)},
               {"farthestTilt", done->farthest_tilt.degrees}};
  figures.update(calls::rounds_json(done->rounds, done->reason));
  return calls::Motion{std::move(done->marker), std::move(figures), done->repair};
}

// motion.relax {"piece", "tilts"?}
struct MotionRelax {
  calls::MotionCall call;
  std::string piece;
  int tilts{};  // 0: the piece keeps its tilt
};

Result<MotionRelax> decode_relax(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionRelax wanted;
  wanted.call = calls::read_call(fields, mistake);
  wanted.piece = fields.id("piece");
  wanted.tilts = static_cast<int>(fields.maybe_integer("tilts", 0, kMostTilts).value_or(0));
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<calls::Motion> run_relax(const MotionRelax& wanted, const Marker& start, const calls::MethodContext& context) {
  const auto piece = calls::piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  scene::Scene scene{start, context.run.sums};
  const auto repair = motion::repair::repair_overlaps(scene, context.run);
  if (!repair) return repair.error();
  const Marker healed = scene.result();
  const scene::Scene still{healed, context.run.sums};
  const motion::piece::Relaxation done = wanted.tilts > 0
                                             ? motion::piece::relax_tilted(still, piece->value, wanted.tilts)
                                             : motion::piece::relax(still, piece->value);
  calls::Motion motion{healed, {}, *repair};
  motion.marker.pieces[piece->value] = done.piece;
  motion.figures = {{"at", formats::point_json(done.piece.at, start.resolution)},
                    {"tilt", done.piece.orientation.tilt.degrees},
                    {"freedom", formats::in_unit(done.freedom, start.resolution)},
                    {"stop", calls::name_of(scene::StopReason::kConverged)}};
  return motion;
}

constexpr std::array kTiltParams = together(
    std::array{
        calls::Word{"method", "'linearisation'|'relaxation'", calls::kOptional,
                    "All pieces at once (when absent), or one after another."},
        calls::Word{"limit", "number", calls::kOptional,
                    "Largest tilt in degrees, 0 to 45, in place of every shape's own."},
        calls::Word{"shakes", "integer", calls::kOptional,
                    "So often the pieces are shaken for the rounds to begin again, 0 to 10,000."},
        calls::Word{"tilts", "integer", calls::kOptional, "Of relaxation: so many tilts are tried, 1 to 1,001."},
    },
    calls::kEffortParams);
constexpr std::array kTiltResults = together(
    std::array{
        calls::Word{"lengthCompacted", "number", calls::kRequired, "After compaction, before any piece was tilted."},
        calls::Word{"farthestTilt", "number", calls::kRequired,
                    "The largest tilt of any piece either way, in degrees."},
    },
    calls::kRoundsResults);
constexpr std::array kRelaxParams{
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"tilts", "integer", calls::kOptional, "So many tilts are tried; 0, as when absent: it keeps its tilt."},
};
constexpr std::array kRelaxResults = together(
    std::array{
        calls::Word{"at", "Point", calls::kRequired, "Where it lies now."},
        calls::Word{"tilt", "number", calls::kRequired, "How it is tilted now, in degrees."},
        calls::Word{"freedom", "number", calls::kRequired,
                    "It may move by so much along both axes at once, either way."},
    },
    calls::kStopResults);

constexpr std::array kMethods{
    calls::MarkerMethod{"motion.tilt",
                        calls::MethodKind::kMove,
                        &calls::read_motion<decode_tilt, run_tilt>,
                        {"The marker made shorter with small tilts.", kTiltParams, kTiltResults}},
    calls::MarkerMethod{"motion.relax",
                        calls::MethodKind::kStep,
                        &calls::read_motion<decode_relax, run_relax>,
                        {"One piece goes to where it has most room.", kRelaxParams, kRelaxResults}}};

}  // namespace

std::span<const calls::MarkerMethod> tilting_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
