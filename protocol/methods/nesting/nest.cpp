// marker.nest: places all pieces, also those that do not lie on the cloth yet.
#include "core/nesting/nest.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "protocol/calls/motion.h"
#include "protocol/methods/nesting/nest_params.h"

namespace selvage::protocol::methods::nesting {
namespace {

constexpr double kMostSearches = 64;

struct NestParams {
  calls::CommonParams call;
  NestEffort effort;
  std::optional<std::size_t> searches;
  bool keep_placed{}, from_scratch{};
  std::optional<std::vector<PieceValue>> values;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.part(self.effort);
    v.optional("searches", self.searches,
               "Number of searches, 1 to 64, which run in parallel; the best result is used.  When absent, as "
               "many as there are threads to spare, at most 16, if a time is given, and 1 otherwise.",
               {.range = {{1, kMostSearches}}});
    v.optional("keepPlaced", self.keep_placed,
               "True: pieces that lie on the cloth stay there, except for compaction; false: they are nested again.");
    v.optional(
        "fromScratch", self.from_scratch,
        "True: all pieces but locked ones and groups are taken off the cloth first, and the result may be longer "
        "than the marker was.  Not together with keepPlaced.");
    v.optional("values", self.values, kValuesMeaning, {.entries = {{0, marker::kMaxPieces}}, .entries_are = "values"});
  }
};

struct NestResult {
  std::size_t placed{}, unplaced{};
  std::uint64_t moves{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("placed", self.placed, "Number of pieces that lie on the cloth afterwards.");
    v.required("unplaced", self.unplaced, "Number of pieces for which there was no room on the cloth.");
    v.required("moves", self.moves, "Total number of moves of a piece in all searches.");
    v.part(self.rounds);
  }
};

// With a limit in time, spare threads make the marker shorter and take nothing from the first search.
std::size_t searches_of(const NestParams& params, const selvage::nesting::NestSettings& settings,
                        const Executor& executor) {
  constexpr std::size_t kMostUnasked = 16;
  if (params.searches) return *params.searches;
  return settings.elapsed ? std::min(executor.parallelism(), kMostUnasked) : 1;
}

Result<selvage::nesting::NestSettings> settings_of(const NestParams& params, const Marker& start,
                                                   const Executor& executor) {
  auto budget = budget_of(params.effort);
  if (!budget) return budget.error();
  auto values = values_of(params.values, start);
  if (!values) return values.error();
  selvage::nesting::NestSettings settings;
  settings.moves = budget->moves;
  settings.elapsed = std::move(budget->elapsed);
  settings.values = *std::move(values);
  settings.searches = searches_of(params, settings, executor);
  settings.seed = params.effort.seed;
  settings.from_scratch = params.from_scratch;
  if (params.keep_placed) settings.placed = selvage::nesting::layout::PlacedPiecesMay::kNotMove;
  return settings;
}

Result<calls::Motion<NestResult>> run_nest(const NestParams& params, const Marker& start,
                                           const calls::MethodContext& context) {
  if (params.keep_placed && params.from_scratch) {
    return Error{ErrorCode::kOutOfRange, "fromScratch and keepPlaced are both true; at most one of them may be true",
                 "/fromScratch"};
  }
  const auto settings = settings_of(params, start, *context.run.executor);
  if (!settings) return settings.error();
  auto done = nest(start, *settings, context.run);
  if (!done) return done.error();
  const NestResult result{.placed = piece_count(done->marker),
                          .unplaced = done->marker.unplaced.size(),
                          .moves = done->moves,
                          .rounds = {done->rounds, cause_of_end(done->reason, done->out_of_time, context)}};
  return calls::Motion<NestResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method nest_method() {
  return calls::motion_method("marker.nest", calls::MethodKind::kMotion,
                              "Places all pieces, so that the marker is as short as the budget allows.", run_nest);
}

}  // namespace selvage::protocol::methods::nesting
