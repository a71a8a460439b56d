// motion.separate: separates overlapping pieces with little motion and reports remaining overlaps [Li94 5.2].
#include "core/motion/separation/separate.h"

#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr double kMostGrowth = 10;  // of the marker's length

struct SeparateParams {
  calls::CommonParams call;
  motion::separation::SeparationSettings settings;
  bool partial{};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional("grow", self.settings.grow,
               "The fraction of its length by which the marker may become longer, 0 to 10; 0 when absent.",
               {.range = {{0, kMostGrowth}}});
    v.optional("popOut", self.settings.pop_out,
               "When the pieces cannot be separated, leave out those that block the rest.");
    v.optional("target", self.settings.target, "How the target of a pair is chosen; nearest when absent.");
    v.optional("rounds", self.settings.rounds, calls::Effort::kRoundsMeaning, calls::kRoundLimits);
    v.optional("partial", self.partial, "Commit the result even when pieces still overlap.");
  }
};

struct SeparateResult {
  bool apart{};
  double moved{}, farthest_move{};
  std::vector<calls::Overlap> remaining;
  std::vector<std::string> popped;
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("apart", self.apart, "Whether all overlaps are gone.");
    v.required("moved", self.moved, "The sum over the pieces of the distances moved along x and along y.");
    v.required("farthestMove", self.farthest_move, "The largest of these distances.");
    v.required("remaining", self.remaining, "Pairs that still overlap.");
    v.required("popped", self.popped, "Ids of the pieces left out.");
    v.part(self.rounds);
  }
};

Result<calls::Motion<SeparateResult>> run_separate(const SeparateParams& params, const Marker& start,
                                                   const calls::MethodContext& context) {
  auto done = separate(start, params.settings, context.run);
  if (!done) return done.error();
  SeparateResult result{.apart = done->apart,
                        .moved = formats::in_unit(done->moved, start.resolution),
                        .farthest_move = to_decimal(done->farthest_move, start.resolution),
                        .remaining = calls::overlaps_of(done->marker, done->remaining),
                        .popped = {},
                        .rounds = {done->rounds, stop_cause(done->reason, context)}};
  for (const PieceId piece : done->popped) result.popped.push_back(start.pieces[piece.value].id);
  return calls::Motion<SeparateResult>{{std::move(done->marker), {}, params.partial}, std::move(result)};
}

}  // namespace

calls::Method separate_method() {
  return calls::motion_method("motion.separate", calls::MethodKind::kMotion,
                              "Separates overlapping pieces with little motion.", run_separate);
}

}  // namespace selvage::protocol::methods::motions
