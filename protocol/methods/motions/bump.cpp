#include "protocol/methods/motions/bump.h"

#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

Result<calls::Motion> run(const MotionBump& wanted, const Marker& start, const calls::MethodContext& context) {
  const auto piece = calls::piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  auto before = laid_out(start, context);
  auto done = context.engine.bump(start, *before, *piece, wanted.direction.x, wanted.direction.y, context.run);
  if (!done) return done.error();
  Json touching = Json::array();
  for (const std::uint32_t other : done->bump.touching) touching.push_back(start.pieces[other].id);
  Json figures{{"at", formats::point_json(done->bump.at, start.resolution)},
               {"gain", formats::in_unit(done->bump.gain, start.resolution)},
               {"touching", std::move(touching)},
               {"moved", done->bump.at != start.pieces[piece->value].at}};
  figures["stop"] = calls::name_of(done->bump.reason);
  return calls::Motion{std::move(done->marker), std::move(figures), done->repair, false, std::move(before)};
}

constexpr std::array kParams{
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"direction", "Direction", calls::kRequired, "Where to."},
};
constexpr std::array kResults = together(
    std::array{
        calls::Word{"at", "Point", calls::kRequired, "Where the piece's origin now lies; exact."},
        calls::Word{"gain", "number", calls::kRequired, "How far it came in the direction."},
        calls::Word{"touching", "string[]", calls::kRequired, "Ids of the pieces that hold it there."},
        calls::Word{"moved", "boolean", calls::kRequired, "Is it elsewhere than before?"},
    },
    calls::kStopResults);

constexpr std::array kMethods{
    calls::MarkerMethod{"motion.bump",
                        calls::MethodKind::kStep,
                        &calls::read_motion<decode_motion_bump, run>,
                        {"One piece slides as far as it can, all others still.", kParams, kResults}}};

}  // namespace

Result<MotionBump> decode_motion_bump(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionBump bump;
  bump.call = calls::read_call(fields, mistake);
  bump.piece = fields.id("piece");
  bump.direction = calls::read_direction(fields, "direction", mistake);
  fields.finish();
  if (mistake) return mistake.error();
  return bump;
}

std::span<const calls::MarkerMethod> bumping_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
