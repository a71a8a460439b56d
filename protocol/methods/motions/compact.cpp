// motion.compact: shortens the marker [Li94 4.1].
#include <cstdint>
#include <limits>

#include "core/motion/compaction/compact.h"
#include "core/search/refine.h"
#include "protocol/calls/motion.h"
#include "protocol/execution/time_limit.h"

namespace selvage::protocol::methods::motions {
namespace {

struct CompactParams {
  calls::CommonParams call;
  calls::Effort effort;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.part(self.effort);
  }
};

// With a deadline the search continues until then.
search::RefineSettings search_settings(const calls::CommonParams& call, const calls::MethodContext& context) {
  search::RefineSettings settings = search::refine_settings();
  if (call.deadline_ms && context.time_left) {
    settings.effort = settings.least_effort = std::numeric_limits<std::uint64_t>::max();
    settings.most_pieces_swapped = marker::kMaxPieces;
    settings.elapsed = execution::elapsed_within(*context.time_left);
  }
  return settings;
}

Result<calls::Motion<calls::RoundsResult>> run_compact(const CompactParams& params, const Marker& start,
                                                       const calls::MethodContext& context) {
  // With a limit on the rounds or a simplification, only a compaction is run, without a search.
  const calls::Effort& effort = params.effort;
  const bool search =
      effort.accuracy == motion::compaction::Accuracy::kFine && !effort.rounds && !effort.simplification;
  auto done = search ? search::refine(start, search_settings(params.call, context), context.run)
                     : compact(start, settings_of(effort), context.run);
  if (!done) return done.error();
  return calls::Motion<calls::RoundsResult>{{std::move(done->marker), done->repair},
                                            {done->rounds, stop_cause(done->reason, context)}};
}

}  // namespace

calls::Method compact_method() {
  return calls::motion_method("motion.compact", calls::MethodKind::kMotion,
                              "Shortens the marker, moving all pieces at once.", run_compact);
}

}  // namespace selvage::protocol::methods::motions
