// marker.nest: places all pieces, also those that do not lie on the cloth yet.
#include "core/nesting/nest.h"

#include <chrono>

#include "protocol/calls/motion.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr double kMostMoves = 1e12, kMostSearches = 64, kMostSeconds = 24 * 3'600, kMostSeed = 9007199254740991.0;
constexpr std::uint64_t kStandardMoves = 20'000;

struct NestParams {
  calls::CommonParams call;
  std::optional<std::uint64_t> moves;
  std::optional<double> seconds;
  std::uint64_t seed{1};
  std::size_t searches{1};
  bool keep_placed{}, from_scratch{};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional(
        "moves", self.moves,
        "The budget of every search in moves of a piece; 20,000 when absent, without limit when seconds are given.",
        {.range = {{0, kMostMoves}}});
    v.optional("seconds", self.seconds,
               "The budget of every search in seconds, 0 to 86,400. The result then depends on the machine.",
               {.range = {{0, kMostSeconds}}});
    v.optional("seed", self.seed, "Of the random choices.", {.range = {{0, kMostSeed}}});
    v.optional("searches", self.searches,
               "Number of independent searches, 1 to 64, of which the best counts; they run in parallel.",
               {.range = {{1, kMostSearches}}});
    v.optional("keepPlaced", self.keep_placed,
               "True: pieces that lie on the cloth stay there, up to compaction; false: they are nested again.");
    v.optional(
        "fromScratch", self.from_scratch,
        "True: all pieces but locked ones and groups are taken off the cloth first, and the result may be longer "
        "than the marker was.  Not together with keepPlaced.");
  }
};

struct NestResult {
  std::size_t placed{}, unplaced{};
  std::uint64_t moves{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("placed", self.placed, "Number of pieces that lie on the cloth afterwards.");
    v.required("unplaced", self.unplaced, "Number of pieces that do not, because the cloth ends before them.");
    v.required("moves", self.moves, "Moves of a piece that all searches have made.");
    v.part(self.rounds);
  }
};

nesting::NestSettings settings_of(const NestParams& params) {
  nesting::NestSettings settings;
  settings.moves = params.moves.value_or(params.seconds ? static_cast<std::uint64_t>(kMostMoves) : kStandardMoves);
  settings.searches = params.searches;
  settings.seed = params.seed;
  settings.from_scratch = params.from_scratch;
  if (params.keep_placed) settings.placed = nesting::layout::PlacedPiecesMay::kNotMove;
  if (params.seconds) {
    const auto start = std::chrono::steady_clock::now();
    settings.elapsed = [start, seconds = *params.seconds] {
      const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
      return seconds > 0 ? passed.count() / seconds : 1;
    };
  }
  return settings;
}

Result<calls::Motion<NestResult>> run(const NestParams& params, const Marker& start,
                                      const calls::MethodContext& context) {
  if (params.keep_placed && params.from_scratch) {
    return Error{ErrorCode::kOutOfRange, "fromScratch is true, and keepPlaced, too; at most one of them may be true",
                 "/fromScratch"};
  }
  auto done = nest(start, settings_of(params), context.run);
  if (!done) return done.error();
  const NestResult result{.placed = done->marker.pieces.size(),
                          .unplaced = done->marker.unplaced.size(),
                          .moves = done->moves,
                          .rounds = {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<NestResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method nest_method() {
  return calls::motion_method("marker.nest", calls::MethodKind::kMotion,
                              "Places all pieces, so that the marker is as short as the budget allows.", run);
}

}  // namespace selvage::protocol::methods::motions
