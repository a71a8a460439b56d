// marker.remake: an order is laid out like the most similar stored markers [Li94 5.3, 10].
#include "core/remake/remake.h"

#include <algorithm>

#include "core/marker/figures.h"
#include "protocol/calls/motion.h"
#include "protocol/library/labels.h"
#include "protocol/methods/library/given_marker.h"

namespace selvage::protocol::schema {

template <>
struct Choices<remake::Outcome> {
  static constexpr std::string_view kName = "RemakeOutcome";
  static constexpr std::string_view kMeaning =
      "The outcome of remaking. remade: laid out like a stored marker; nested: nested from nothing, as requested; "
      "none_near: no stored marker is similar enough; not_apart: no attempt could separate its pieces on the cloth.";
  static constexpr std::string_view kWords[] = {"remade", "nested", "none_near", "not_apart"};
};

template <>
struct Choices<remake::StepKind> {
  static constexpr std::string_view kName = "RemakeStep";
  static constexpr std::string_view kMeaning =
      "A step of an attempt. substituted: the pieces replace stored ones; separated, popped, searched: overlaps were "
      "removed by linear programs, by taking small pieces out and putting them back, or by a search; compacted; "
      "inserted: pieces without a corresponding stored piece were added; tilted: small tilts made the marker shorter; "
      "rearranged: a short search found a shorter marker; trims_moved: small pieces were moved into gaps; refined: "
      "like accuracy fine.";
  static constexpr std::string_view kWords[] = {"substituted", "separated", "popped",     "searched",    "compacted",
                                                "inserted",    "tilted",    "rearranged", "trims_moved", "refined"};
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::library {
namespace {

constexpr double kMostTries = 64, kMostMoves = 1e12;

struct RemakeParams {
  calls::CommonParams call;
  std::optional<std::vector<GivenMarker>> stored;
  std::size_t tries{remake::RemakeSettings{}.tries};
  bool shapes_only{}, single{}, thorough{}, keep_trims{}, fine{}, nest{};
  std::uint64_t nest_moves{remake::RemakeSettings{}.nest_moves};

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional("stored", self.stored,
               "The stored markers to choose from, as native or sparrow documents; the most similar ones are tried. "
               "Those of the library when absent.",
               {.entries = {{1, kMostStored}}, .entries_are = "markers"});
    v.optional("tries", self.tries, "Maximum number of arrangements to try, 1 to 64; the shortest result is used.",
               {.range = {{1, kMostTries}}});
    v.optional("shapesOnly", self.shapes_only,
               "True: choose the stored piece for each piece by shape alone. False: names and sizes count, too, where "
               "both pieces have them.");
    v.optional("single", self.single, "True: use only one stored marker at a time; never put two of them end to end.");
    v.optional(
        "thorough", self.thorough,
        "True: make all tries, and search for a shorter marker in each. False: make no further try after a first "
        "result whose utilisation is at most one point below that of the stored marker, and search for a "
        "shorter marker in the best result only.");
    v.optional("keepTrims", self.keep_trims,
               "True: after the search for a shorter marker, do not move small pieces into gaps.");
    v.optional("fine", self.fine, "Whether the result is refined, after a search four times as long.");
    v.optional("nest", self.nest, "Whether the order is nested from nothing when no attempt gives a marker.");
    v.optional("nestMoves", self.nest_moves, "The budget of nesting from nothing, in moves of a piece.",
               {.range = {{1, kMostMoves}}});
  }
};

struct RemakeStepResult {
  static constexpr std::string_view kName = "RemakeStepResult", kMeaning = "The marker after a step of an attempt.";
  remake::StepKind step{};
  std::size_t pieces{};
  double length{}, utilisation{};
  bool valid{};

  static void describe(auto& v, auto& self) {
    v.required("step", self.step, "What was done.");
    v.required("pieces", self.pieces,
               "Number of pieces swapped to relieve columns, popped or inserted, or number of trials kept.");
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("utilisation", self.utilisation,
               "The utilisation of the pieces that are placed after the step, 0 to 1.");
    v.required("valid", self.valid, calls::kValidMeaning);
  }
};

struct RemakeAttempt {
  static constexpr std::string_view kName = "RemakeAttempt", kMeaning = "An attempt to use one arrangement.";
  std::vector<std::size_t> stored;
  double difference{}, predicted{};
  bool made{};
  std::vector<RemakeStepResult> steps;

  static void describe(auto& v, auto& self) {
    v.required(
        "stored", self.stored,
        "The positions of the markers in `stored`, or among the most similar ones of the library, from left to right.");
    v.required("difference", self.difference, "How much the pieces differ, as a fraction of the order's area.");
    v.required("predicted", self.predicted, "The utilisation that was expected, 0 to 1.");
    v.required("made", self.made, "Whether it gave a valid marker with all pieces.");
    v.required("steps", self.steps, "What was done, in order.");
  }
};

struct RemakeResult {
  remake::Outcome outcome{};
  std::size_t candidates{};
  std::optional<std::size_t> chosen;
  std::vector<RemakeAttempt> attempts;
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("outcome", self.outcome, "The outcome. The marker changes only if the order was remade or nested.");
    v.required("candidates", self.candidates, "Number of arrangements that were similar enough.");
    v.optional("chosen", self.chosen, "The attempt that the result is from.");
    v.required("attempts", self.attempts, "The attempts, the best prediction first.");
    v.part(self.rounds);
  }
};

RemakeAttempt report_of(const remake::Attempt& attempt, const Marker& order) {
  RemakeAttempt report{.stored = attempt.stored,
                       .difference = attempt.difference,
                       .predicted = attempt.predicted,
                       .made = attempt.marker.has_value(),
                       .steps = {}};
  Marker after = order;
  for (const remake::Step& step : attempt.steps) {
    after.pieces = step.placed;
    report.steps.push_back({.step = step.kind,
                            .pieces = step.pieces,
                            .length = to_decimal(step.length, order.resolution),
                            .utilisation = utilisation_at(after, step.length),
                            .valid = step.valid});
  }
  return report;
}

matching::LabelledMarker compared(const RemakeParams& params, const MarkerFile& file) {
  return params.shapes_only ? matching::LabelledMarker{file.marker, {}} : protocol::library::labelled(file);
}

Result<std::vector<matching::LabelledMarker>> stored_for(const RemakeParams& params, const Marker& order,
                                                         const calls::MethodContext& context) {
  std::vector<matching::LabelledMarker> stored;
  if (params.stored) {
    for (const GivenMarker& given : *params.stored) stored.push_back(compared(params, given.file));
  } else if (context.library) {
    for (const MarkerFile& file : context.library(order, kNearest)) stored.push_back(compared(params, file));
  } else {
    return Error{ErrorCode::kMissingField, "the field is missing; it is required where there is no library", "/stored"};
  }
  return stored;
}

Result<calls::Motion<RemakeResult>> run_remake(const RemakeParams& params, const MarkerFile& file,
                                               const calls::MethodContext& context) {
  const Marker& order = file.marker;
  remake::RemakeSettings settings;
  settings.tries = params.tries;
  settings.concatenate = !params.single;
  settings.thorough = params.thorough;
  settings.attempt.trims = !params.keep_trims;
  settings.attempt.fine = params.fine;
  settings.nest = params.nest;
  settings.nest_moves = params.nest_moves;
  const auto stored = stored_for(params, order, context);
  if (!stored) return stored.error();
  auto done = remake::remake(compared(params, file), *stored, settings, context.run);
  if (!done) return done.error();
  RemakeResult result{.outcome = done->outcome,
                      .candidates = done->candidates,
                      .chosen = done->chosen,
                      .attempts = {},
                      .rounds = {done->rounds, stop_cause(done->reason, context)}};
  for (const remake::Attempt& attempt : done->attempts) result.attempts.push_back(report_of(attempt, order));
  return calls::Motion<RemakeResult>{{std::move(done->marker), done->repair}, std::move(result)};
}

}  // namespace

calls::Method remake_method() {
  return calls::motion_method("marker.remake", calls::MethodKind::kMotion,
                              "Lays the pieces of an order out like those of the most similar stored markers.",
                              run_remake);
}

}  // namespace selvage::protocol::methods::library
