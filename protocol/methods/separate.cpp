#include "protocol/methods/separate.h"

#include <array>

#include "protocol/codec.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

Result<Motion> run(const MotionSeparate& wanted, const Marker& start, const Means& means) {
  auto done = separate(start, wanted.settings, means.sums, means.stop, means.observer);
  if (!done) return done.error();
  Json popped = Json::array();
  for (const PieceId piece : done->popped) popped.push_back(start.pieces[piece.value].id);
  Json figures{{"apart", done->apart},
               {"moved", in_unit(done->moved, start.resolution)},
               {"farthestMove", to_decimal(done->farthest_move, start.resolution)},
               {"remaining", overlaps_json(done->marker, done->remaining)},
               {"popped", std::move(popped)}};
  figures.update(rounds_json(done->rounds, done->reason));
  return Motion{std::move(done->marker), std::move(figures), {}, wanted.partial};
}

constexpr std::array kParams = together(
    std::array{
        Word{"grow", "number", kOptional,
             "The part of its length that the marker may become longer by, 0 to 10; 0 when absent."},
        Word{"popOut", "boolean", kOptional,
             "When the pieces cannot be parted, leave out those that hold up the rest."},
        Word{"partial", "boolean", kOptional, "Commit what was reached even when pieces still overlap."},
        Word{"target", "TargetRule", kOptional, "Where a pair is aimed; nearest when absent."},
    },
    kRoundsParams);
constexpr std::array kResults = together(
    std::array{
        Word{"apart", "boolean", kRequired, "Nothing overlaps any more."},
        Word{"moved", "number", kRequired, "The sum over the pieces of how far each moved along x and along y."},
        Word{"farthestMove", "number", kRequired, "The largest of these."},
        Word{"remaining", "Overlap[]", kRequired, "Pairs that still overlap."},
        Word{"popped", "string[]", kRequired, "Ids of the pieces left out."},
    },
    kRoundsResults);

constexpr std::array kMethods{MarkerMethod{"motion.separate",
                                           MethodKind::kMove,
                                           &read_motion<decode_motion_separate, run>,
                                           {"Overlapping pieces parted with little motion.", kParams, kResults}}};

}  // namespace

Result<MotionSeparate> decode_motion_separate(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionSeparate separate;
  SeparationSettings& settings = separate.settings;
  separate.call = read_call(fields, mistake);
  settings.grow = fields.number_or("grow", settings.grow, {0, kMostGrowth});
  settings.pop_out = fields.flag_or("popOut", settings.pop_out);
  settings.target =
      static_cast<TargetRule>(fields.word_or("target", static_cast<std::size_t>(settings.target), kTargetNames));
  settings.rounds = read_rounds(fields).value_or(settings.rounds);
  separate.partial = fields.flag_or("partial", separate.partial);
  fields.finish();
  if (mistake) return mistake.error();
  return separate;
}

std::span<const MarkerMethod> separation_methods() {
  return kMethods;
}

}  // namespace selvage
