#include "protocol/methods/bump.h"

#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

Result<Motion> run(const MotionBump& wanted, const Marker& start, const Means& means) {
  const auto piece = piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  auto before = laid_out(start, means);
  auto done = means.engine.bump(start, *before, *piece, wanted.direction.x, wanted.direction.y, means.sums, means.stop,
                                means.observer);
  if (!done) return done.error();
  Json touching = Json::array();
  for (const std::uint32_t other : done->bump.touching) touching.push_back(start.pieces[other].id);
  Json figures{{"at", point_json(done->bump.at, start.resolution)},
               {"gain", in_unit(done->bump.gain, start.resolution)},
               {"touching", std::move(touching)},
               {"moved", done->bump.at != start.pieces[piece->value].at}};
  figures["stop"] = name_of(done->bump.reason);
  return Motion{std::move(done->marker), std::move(figures), done->healing, false, std::move(before)};
}

constexpr std::array kParams{
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"direction", "Direction", kRequired, "Where to."},
};
constexpr std::array kResults = together(
    std::array{
        Word{"at", "Point", kRequired, "Where the piece's origin now lies; exact."},
        Word{"gain", "number", kRequired, "How far it came in the direction."},
        Word{"touching", "string[]", kRequired, "Ids of the pieces that hold it there."},
        Word{"moved", "boolean", kRequired, "Is it elsewhere than before?"},
    },
    kStopResults);

constexpr std::array kMethods{
    MarkerMethod{"motion.bump",
                 MethodKind::kStep,
                 &read_motion<decode_motion_bump, run>,
                 {"One piece slides as far as it can, all others still.", kParams, kResults}}};

}  // namespace

Result<MotionBump> decode_motion_bump(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionBump bump;
  bump.call = read_call(fields, mistake);
  bump.piece = fields.id("piece");
  bump.direction = read_direction(fields, "direction", mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return bump;
}

std::span<const MarkerMethod> bumping_methods() {
  return kMethods;
}

}  // namespace selvage
