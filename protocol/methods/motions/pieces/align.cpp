// motion.align: moves the chosen pieces so that one side of each lies on one line.
#include "core/motion/placing/align.h"

#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions::pieces {
namespace {

struct AlignParams {
  calls::CommonParams call;
  std::vector<calls::Id> pieces;
  StripEdge side{};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("pieces", self.pieces, "The ids of the pieces to align; two or more.",
               {.entries = {{2, marker::kMaxPieces}}, .entries_are = "pieces"});
    v.required("side", self.side, "The side of the pieces that is aligned: the one facing this edge of the strip.");
  }
};

struct AlignResult {
  double line{};
  std::size_t aligned{};
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("line", self.line, "Where the sides lie: an x for left and right, a y for bottom and top.");
    v.required("aligned", self.aligned,
               "How many of the pieces lie on the line; the rest are blocked by other pieces.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

Result<calls::Motion<AlignResult>> run_align(const AlignParams& params, const Marker& start,
                                             const calls::MethodContext& context) {
  const calls::PiecesById by_id{start};
  std::vector<PieceId> pieces;
  for (const calls::Id& id : params.pieces) {
    const auto piece = by_id.piece_of(id.text, "/pieces/" + std::to_string(pieces.size()));
    if (!piece) return piece.error();
    pieces.push_back(*piece);
  }
  auto done = motion::placing::align(start, pieces, params.side, context.run);
  if (!done) return done.error();
  const AlignResult result{.line = formats::in_unit(static_cast<double>(done->line), start.resolution),
                           .aligned = done->aligned,
                           .stop = calls::stop_cause(done->reason, context)};
  return calls::Motion<AlignResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method align_method() {
  return calls::motion_method("motion.align", calls::MethodKind::kStep,
                              "Moves pieces along one axis until one side of each lies on one line.", run_align);
}

}  // namespace selvage::protocol::methods::motions::pieces
