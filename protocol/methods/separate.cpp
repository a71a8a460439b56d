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

constexpr std::array kMethods{MarkerMethod{"motion.separate", true, &read_motion<decode_motion_separate, run>}};

}  // namespace

Result<MotionSeparate> decode_motion_separate(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionSeparate separate;
  SeparationSettings& settings = separate.settings;
  separate.call = read_call(fields);
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
