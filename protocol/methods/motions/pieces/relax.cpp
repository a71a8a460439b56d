// motion.relax: one piece moves to where it has the most room [Li94 6.1].
#include "core/motion/piece/relax.h"

#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions::pieces {
namespace {

constexpr double kMostTilts = 1'001;

struct RelaxParams {
  calls::CommonParams call;
  calls::Id piece;
  int tilts{};  // 0: the piece keeps its tilt

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.optional("tilts", self.tilts,
               "Number of tilt angles sampled, 0 to 1,001; with 0, as when absent, the piece keeps its tilt.",
               {.range = {{0, kMostTilts}}});
  }
};

struct RelaxResult {
  calls::Point at;
  double tilt{}, freedom{};
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("at", self.at, "The piece's new position.");
    v.required("tilt", self.tilt, "Its new tilt in degrees.");
    v.required("freedom", self.freedom, "Half-side of the largest square of free translations.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

Result<calls::Motion<RelaxResult>> run_relax(const RelaxParams& params, const Marker& start,
                                             const calls::MethodContext& context) {
  const auto piece = calls::piece_of(start, params.piece.text, "/piece");
  if (!piece) return piece.error();
  auto done = motion::piece::repair_and_relax(start, *piece, params.tilts, context.run);
  if (!done) return done.error();
  const auto& [relaxed, freedom] = done->relaxation;
  const RelaxResult result{.at = calls::point_of(relaxed.at, start.resolution),
                           .tilt = relaxed.orientation.tilt.degrees,
                           .freedom = formats::in_unit(freedom, start.resolution),
                           .stop = stop_cause(done->reason, context)};
  return calls::Motion<RelaxResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method relax_method() {
  return calls::motion_method("motion.relax", calls::MethodKind::kStep,
                              "Moves one piece to where it has the most room.", run_relax);
}

}  // namespace selvage::protocol::methods::motions::pieces
