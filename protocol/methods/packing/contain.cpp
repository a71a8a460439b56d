// motion.contain: whether pieces fit into the room that the others leave, and where [Li94 8.3].
#include "core/packing/contain.h"

#include <algorithm>

#include "protocol/methods/packing/search.h"

namespace selvage::protocol::methods::packing {
namespace {

constexpr std::size_t kMostPieces = 64;

struct PieceToPlace {
  static constexpr std::string_view kName = "PieceToPlace", kMeaning = "A piece that is to be placed.";
  calls::Id piece;

  static void describe(auto& v, auto& self) { v.required("piece", self.piece, calls::kPieceMeaning); }
};

struct ContainParams {
  calls::CommonParams call;
  std::vector<PieceToPlace> pieces;
  std::optional<calls::Point> low, high;
  SearchEffort effort;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("pieces", self.pieces, "The pieces to place, 1 to 64; all others stay where they are.",
               {.entries = {{1, kMostPieces}}, .entries_are = "pieces"});
    v.optional("low", self.low, "The low corner of the box to place them in; the strip's start when absent.");
    v.optional("high", self.high, "Its high corner; the present end of the other pieces when absent.");
    v.part(self.effort);
  }
};

struct ContainResult {
  selvage::packing::Verdict verdict{};
  SearchReport report;

  static void describe(auto& v, auto& self) {
    v.required("verdict", self.verdict, "Whether the pieces fit.");
    v.part(self.report);
  }
};

// The x coordinate at which the pieces end that stay where they are.
Coord end_of_others(const Marker& marker, const std::vector<PieceId>& moving) {
  const marker::PlacedPieces pieces{marker};
  Coord end = 0;
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    if (std::find(moving.begin(), moving.end(), PieceId{k}) == moving.end()) end = std::max(end, pieces.box(k).high.x);
  }
  return end;
}

Result<calls::Motion<ContainResult>> run(const ContainParams& params, const Marker& start,
                                         const calls::MethodContext& context) {
  std::vector<PieceId> pieces;
  for (std::size_t k = 0; k < params.pieces.size(); ++k) {
    const auto piece = calls::piece_of(start, params.pieces[k].piece.text, "/pieces/" + std::to_string(k) + "/piece");
    if (!piece) return piece.error();
    pieces.push_back(*piece);
  }
  Box room = selvage::packing::room_until(start.strip, end_of_others(start, pieces));
  for (const bool low : {true, false}) {
    const auto& corner = low ? params.low : params.high;
    if (!corner) continue;
    const auto at = calls::place_on_lattice(*corner, start.resolution, low ? "/low" : "/high");
    if (!at) return at.error();
    (low ? room.low : room.high) = *at;
  }
  selvage::packing::ContainSettings settings;
  settings.limits = params.effort.limits();
  settings.turns = params.effort.turns;
  auto done = selvage::packing::contain(start, pieces, room, settings, context.run);
  return calls::Motion<ContainResult>{
      {std::move(done.marker)}, {done.verdict, report_of(done.work, done.rounds, stop_cause(done.reason, context))}};
}

}  // namespace

calls::Method contain_method() {
  return calls::motion_method("motion.contain", calls::MethodKind::kMotion,
                              "Places pieces in the room that the others leave, or proves that they do not fit.", run);
}

}  // namespace selvage::protocol::methods::packing
