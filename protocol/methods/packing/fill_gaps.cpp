// marker.fillGaps: small pieces are taken out, the others compacted, and the small ones put back where there is room.
#include "core/packing/refitting/fill_gaps.h"

#include "protocol/methods/packing/search_params.h"

namespace selvage::protocol::methods::packing {
namespace {

namespace refitting = selvage::packing::refitting;

constexpr double kMostTrials = 1e9, kMostTaken = 12;

struct FillParams {
  calls::CommonParams call;
  std::optional<std::uint64_t> trials;
  std::size_t pieces{refitting::GapSettings{}.pieces};
  std::uint64_t nodes{refitting::GapSettings{}.nodes};
  std::uint64_t seed{refitting::GapSettings{}.seed};
  bool turns{true};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional(
        "trials", self.trials,
        "How many times small pieces are taken out and put back; 200 when absent, without limit when time is limited.",
        {.range = {{0, kMostTrials}}});
    v.optional("pieces", self.pieces, "Maximum number of pieces taken out in a trial, 1 to 12.",
               {.range = {{1, kMostTaken}}});
    v.optional("nodes", self.nodes, "The largest number of nodes of every search for room.",
               {.range = {{1, kMostNodes}}});
    v.optional("seed", self.seed, "The seed of the random choices.", {.range = {{0, calls::kMostSeed}}});
    v.optional("turns", self.turns, "False: pieces keep their orientations.");
  }
};

struct FillResult {
  std::size_t placed{}, unplaced{};
  std::uint64_t kept{}, nodes{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("placed", self.placed, "Number of unplaced pieces that found room.");
    v.required("unplaced", self.unplaced, "Number of pieces that do not lie on the cloth afterwards.");
    v.required("kept", self.kept, "Number of trials that made the marker shorter.");
    v.required("nodes", self.nodes, "Number of nodes of all searches for room.");
    v.part(self.rounds);
  }
};

Result<calls::Motion<FillResult>> run_fill_gaps(const FillParams& params, const Marker& start,
                                                const calls::MethodContext& context) {
  refitting::GapSettings settings;
  settings.trials = params.trials.value_or(params.call.deadline_ms ? UINT64_MAX : settings.trials);
  settings.pieces = params.pieces;
  settings.nodes = params.nodes;
  settings.seed = params.seed;
  settings.turns = params.turns;
  auto done = fill_gaps(start, settings, context.run);
  if (!done) return done.error();
  const FillResult result{.placed = done->placed,
                          .unplaced = done->marker.unplaced.size(),
                          .kept = done->kept,
                          .nodes = done->work.nodes,
                          .rounds = {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<FillResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method fill_gaps_method() {
  return calls::motion_method("marker.fillGaps", calls::MethodKind::kMotion,
                              "Shortens the marker by taking small pieces out and putting them back where there is "
                              "room.",
                              run_fill_gaps);
}

}  // namespace selvage::protocol::methods::packing
