#include "protocol/methods/motions/separate.h"

#include <array>

#include "protocol/calls/codec.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

Result<calls::Motion> run(const MotionSeparate& wanted, const Marker& start, const calls::MethodContext& context) {
  auto done = separate(start, wanted.settings, context.run);
  if (!done) return done.error();
  Json popped = Json::array();
  for (const PieceId piece : done->popped) popped.push_back(start.pieces[piece.value].id);
  Json figures{{"apart", done->apart},
               {"moved", formats::in_unit(done->moved, start.resolution)},
               {"farthestMove", to_decimal(done->farthest_move, start.resolution)},
               {"remaining", calls::overlaps_json(done->marker, done->remaining)},
               {"popped", std::move(popped)}};
  figures.update(calls::rounds_json(done->rounds, done->reason));
  return calls::Motion{std::move(done->marker), std::move(figures), {}, wanted.partial};
}

constexpr std::array kParams = together(
    std::array{
        calls::Word{"grow", "number", calls::kOptional,
                    "The part of its length that the marker may become longer by, 0 to 10; 0 when absent."},
        calls::Word{"popOut", "boolean", calls::kOptional,
                    "When the pieces cannot be parted, leave out those that hold up the rest."},
        calls::Word{"partial", "boolean", calls::kOptional, "Commit what was reached even when pieces still overlap."},
        calls::Word{"target", "TargetRule", calls::kOptional, "Where a pair is aimed; nearest when absent."},
    },
    calls::kRoundsParams);
constexpr std::array kResults = together(
    std::array{
        calls::Word{"apart", "boolean", calls::kRequired, "Nothing overlaps any more."},
        calls::Word{"moved", "number", calls::kRequired,
                    "The sum over the pieces of how far each moved along x and along y."},
        calls::Word{"farthestMove", "number", calls::kRequired, "The largest of these."},
        calls::Word{"remaining", "Overlap[]", calls::kRequired, "Pairs that still overlap."},
        calls::Word{"popped", "string[]", calls::kRequired, "Ids of the pieces left out."},
    },
    calls::kRoundsResults);

constexpr std::array kMethods{
    calls::MarkerMethod{"motion.separate",
                        calls::MethodKind::kMove,
                        &calls::read_motion<decode_motion_separate, run>,
                        {"Overlapping pieces parted with little motion.", kParams, kResults}}};

}  // namespace

Result<MotionSeparate> decode_motion_separate(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionSeparate separate;
  motion::separation::SeparationSettings& settings = separate.settings;
  separate.call = calls::read_call(fields, mistake);
  settings.grow = fields.number_or("grow", settings.grow, {0, kMostGrowth});
  settings.pop_out = fields.flag_or("popOut", settings.pop_out);
  settings.target = static_cast<motion::repair::TargetRule>(
      fields.word_or("target", static_cast<std::size_t>(settings.target), kTargetNames));
  settings.rounds = calls::read_rounds(fields).value_or(settings.rounds);
  separate.partial = fields.flag_or("partial", separate.partial);
  fields.finish();
  if (mistake) return mistake.error();
  return separate;
}

std::span<const calls::MarkerMethod> separation_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
