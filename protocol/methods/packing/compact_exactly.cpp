// marker.compactExactly: places the pieces of a window anew, so that the pieces behind it can move closer; windows
// slide over the marker.
#include "core/packing/refitting/compact_exactly.h"

#include "protocol/methods/packing/search_params.h"

namespace selvage::protocol::methods::packing {
namespace {

namespace refitting = selvage::packing::refitting;

constexpr double kMostWindows = 1e9, kMostPieces = 12;
constexpr std::uint64_t kNodesWithDeadline = 20'000;

struct ExactCompactionParams {
  calls::CommonParams call;
  std::size_t pieces{refitting::ExactCompactionSettings{}.pieces};
  std::optional<std::uint64_t> nodes, windows;
  std::optional<std::vector<calls::Id>> among;
  bool turns{true};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional("pieces", self.pieces, "Number of pieces in a window, 1 to 12.", {.range = {{1, kMostPieces}}});
    v.optional("nodes", self.nodes,
               "The largest number of nodes of the search in a window; 300 when absent, 20,000 when time is limited.",
               {.range = {{1, kMostNodes}}});
    v.optional("windows", self.windows,
               "Maximum number of windows to search; 1,000 when absent, without limit when time is limited.",
               {.range = {{0, kMostWindows}}});
    v.optional("among", self.among,
               "Ids of placed pieces: windows that hold none of them are left out; when absent, all are searched.",
               {.entries = {{1, marker::kMaxPieces}}, .entries_are = "pieces"});
    v.optional("turns", self.turns, "False: pieces keep their orientations.");
  }
};

struct ExactCompactionResult {
  std::uint64_t kept{}, nodes{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("kept", self.kept, "Number of windows that made the marker shorter.");
    v.required("nodes", self.nodes, "Number of nodes of all searches.");
    v.part(self.rounds);
  }
};

Result<std::vector<PieceId>> placed_pieces(const Marker& marker, const std::vector<calls::Id>& ids) {
  const calls::PiecesById by_id{marker};
  std::vector<PieceId> pieces;
  for (const calls::Id& id : ids) {
    const auto piece = by_id.piece_of(id.text, "/among/" + std::to_string(pieces.size()));
    if (!piece) return piece.error();
    pieces.push_back(*piece);
  }
  return pieces;
}

Result<calls::Motion<ExactCompactionResult>> run_compact_exactly(const ExactCompactionParams& params,
                                                                 const Marker& start,
                                                                 const calls::MethodContext& context) {
  refitting::ExactCompactionSettings settings;
  settings.pieces = params.pieces;
  const bool timed = params.call.deadline_ms.has_value();
  settings.nodes = params.nodes.value_or(timed ? kNodesWithDeadline : settings.nodes);
  settings.windows = params.windows.value_or(timed ? UINT64_MAX : settings.windows);
  if (params.among) {
    auto among = placed_pieces(start, *params.among);
    if (!among) return among.error();
    settings.among = *std::move(among);
  }
  settings.turns = params.turns;
  auto done = compact_exactly(start, settings, context.run);
  if (!done) return done.error();
  const ExactCompactionResult result{
      .kept = done->kept, .nodes = done->work.nodes, .rounds = {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<ExactCompactionResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method compact_exactly_method() {
  return calls::motion_method(
      "marker.compactExactly", calls::MethodKind::kMotion,
      "Shortens the marker by exact searches for new positions of the pieces in one window after another.",
      run_compact_exactly);
}

}  // namespace selvage::protocol::methods::packing
