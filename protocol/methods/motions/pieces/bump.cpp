// motion.bump: one piece slides as far as it can while all others stay [Li94 4.2.3].
#include "core/motion/piece/bump.h"

#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions::pieces {
namespace {

struct BumpParams {
  calls::CommonParams call;
  calls::Id piece;
  calls::Direction direction;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("direction", self.direction, "The direction in which the piece slides; its length does not matter.");
  }
};

struct BumpResult {
  calls::Point at;
  double gain{};
  std::vector<std::string> touching;
  bool moved{};
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("at", self.at, "The new position of the piece's origin; exact.");
    v.required("gain", self.gain, "How far it moved in the direction.");
    v.required("touching", self.touching, "Ids of the pieces that block it there.");
    v.required("moved", self.moved, "Whether its position changed.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

Result<calls::Motion<BumpResult>> run_bump(const BumpParams& params, const Marker& start,
                                           const calls::MethodContext& context) {
  const auto piece = calls::piece_of(start, params.piece.text, "/piece");
  if (!piece) return piece.error();
  auto before = laid_out(start, context);
  auto done =
      motion::piece::repair_and_bump(start, *before, *piece, params.direction.x, params.direction.y, context.run);
  if (!done) return done.error();
  BumpResult result{.at = calls::point_of(done->bump.at, start.resolution),
                    .gain = formats::in_unit(done->bump.gain, start.resolution),
                    .touching = {},
                    .moved = done->bump.at != start.pieces[piece->value].at,
                    .stop = stop_cause(done->bump.reason, context)};
  for (const PieceId other : done->bump.touching) result.touching.push_back(start.pieces[other.value].id);
  return calls::Motion<BumpResult>{{std::move(done->marker), done->repair, false, std::move(before)},
                                   std::move(result)};
}

}  // namespace

calls::Method bump_method() {
  return calls::motion_method("motion.bump", calls::MethodKind::kStep,
                              "Slides one piece as far as it can go while all others stay.", run_bump);
}

}  // namespace selvage::protocol::methods::motions::pieces
