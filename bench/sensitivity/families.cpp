#include <random>

#include "bench/sensitivity/family.h"
#include "core/marker/placed_pieces.h"
#include "core/minkowski/inner_fit.h"
#include "core/motion/compaction/compact.h"
#include "core/motion/floating/float_apart.h"
#include "core/motion/separation/separate.h"
#include "core/motion/tilting/tilt.h"
#include "core/nesting/nest.h"
#include "core/search/refine.h"

namespace selvage::bench::sensitivity {
namespace {

using motion::compaction::Accuracy;

constexpr double kGrow = 0.02;           // of the length, for separation
constexpr double kNoise = 0.02;          // of the width: how far the pieces to be separated were pushed
constexpr double kTilt = 2;              // degrees, for all pieces of markers to be tilted
constexpr std::uint64_t kSwaps = 6'000;  // effort of a search
constexpr std::uint64_t kMoves = 6'000;  // of a nesting

template <class Done>
double ratio_of(const Done& done) {
  return static_cast<double>(done.length_after) / static_cast<double>(done.length_before);
}

template <class Tuning, class Settings>
Tuning& own_tuning(Settings& settings) {
  return settings.tuning;
}

Marker as_it_is(const Marker& marker, SumCache& /*sums*/) {
  return marker;
}

// The marker with every piece pushed aside at random, within the strip.
Marker pushed(const Marker& start, SumCache& /*sums*/) {
  Marker marker = start;
  std::mt19937 random{1};
  const auto even = [&] { return 2 * static_cast<double>(random()) / 4294967296.0 - 1; };
  const double most = kNoise * static_cast<double>(marker.strip.width);
  marker.strip.longest = static_cast<Coord>((1 + kGrow) * static_cast<double>(length_of(marker)));
  for (Piece& piece : marker.pieces) {
    const Polygon outline = oriented(marker.shapes[piece.shape.value].outline, piece.orientation);
    const Box fit = minkowski::inner_fit(box_of(outline), marker.strip.room(*marker.strip.last()));
    const Vec at = piece.at + Vec{std::llround(most * even()), std::llround(most * even())};
    piece.at = {std::clamp(at.x, fit.low.x, fit.high.x), std::clamp(at.y, fit.low.y, fit.high.y)};
  }
  return marker;
}

// The same marker, separated: it is valid and has room for compaction.
Marker loosened(const Marker& marker, SumCache& sums) {
  auto apart = motion::separation::separate(pushed(marker, sums), {.grow = kGrow}, {sums});
  return apart && apart->apart ? std::move(apart->marker) : marker;
}

Outcome compacted(const Marker& marker, const motion::compaction::CompactionSettings& settings, SumCache& sums) {
  const auto done = compact(marker, settings, {sums});
  return done ? Outcome{ratio_of(*done), false} : Outcome{.failed = true};
}

Family compaction_family() {
  using motion::compaction::CompactionSettings;
  using motion::compaction::CompactionTuning;
  using motion::step::StepTuning;
  const CompactionSettings settings = compaction_settings(Accuracy::kStandard);
  Family family{"compaction",
                "the length after `compact`, accuracy `standard`, of markers whose pieces were pushed aside by up to 2 "
                "% of the width and separated",
                loosened,
                {}};
  family.constants = constants_of<CompactionTuning, CompactionSettings>(
      settings,
      {{"trust_ahead", &CompactionTuning::trust_ahead},
       {"least_trust", &CompactionTuning::least_trust},
       {"most_near_pairs", &CompactionTuning::most_near_pairs},
       {"long_from", &CompactionTuning::long_from},
       {"little", &CompactionTuning::little},
       {"touching", &CompactionTuning::touching},
       {"loose_below", &CompactionTuning::loose_below},
       {"worth_a_sweep", &CompactionTuning::worth_a_sweep},
       {"sweeps", &CompactionTuning::sweeps},
       {"most_pieces_repeated", &CompactionTuning::most_pieces_repeated},
       {"repeated_in_vain", &CompactionTuning::repeated_in_vain},
       {"most_pieces_swept", &CompactionTuning::most_pieces_swept}},
      own_tuning<CompactionTuning, CompactionSettings>, compacted);
  const auto of_steps = constants_of<StepTuning, CompactionSettings>(
      settings,
      {{"step.programs", &StepTuning::programs},
       {"step.foresight_after", &StepTuning::foresight_after},
       {"step.foresight", &StepTuning::foresight},
       {"step.halvings", &StepTuning::halvings},
       {"step.small_marker", &StepTuning::small_marker},
       {"step.active_set_growth", &StepTuning::active_set_growth},
       {"step.least_gain", &StepTuning::least_gain},
       {"step.broken", &StepTuning::broken},
       {"step.motion_per_trust", &StepTuning::motion_per_trust},
       {"step.region_reach", &StepTuning::region_reach},
       {"step.motion_ahead", &StepTuning::motion_ahead},
       {"step.least_motion", &StepTuning::least_motion},
       {"step.pressed", &StepTuning::pressed},
       {"step.spare_length", &StepTuning::spare_length}},
      [](CompactionSettings& s) -> StepTuning& { return s.tuning.step; }, compacted);
  family.constants.insert(family.constants.end(), of_steps.begin(), of_steps.end());
  return family;
}

Outcome separated(const Marker& marker, const motion::separation::SeparationSettings& settings, SumCache& sums) {
  const auto done = motion::separation::separate(marker, settings, {sums});
  if (!done || !done->apart) return {.failed = true};
  return {static_cast<double>(done->length_after), false};
}

Family separation_family() {
  using motion::separation::SeparationSettings;
  using motion::separation::SeparationTuning;
  using T = SeparationTuning;
  return {"separation", "the length after `separate` of pieces that were pushed aside by up to 2 % of the width",
          pushed,
          constants_of<T, SeparationSettings>({.grow = kGrow},
                                              {{"overlap_price", &T::overlap_price},
                                               {"price_growth", &T::price_growth},
                                               {"highest_price", &T::highest_price},
                                               {"length_price", &T::length_price},
                                               {"excess_price", &T::excess_price},
                                               {"reach", &T::reach},
                                               {"least_reach", &T::least_reach},
                                               {"most_reach", &T::most_reach},
                                               {"rounding", &T::rounding},
                                               {"leap_after", &T::leap_after},
                                               {"leap_reach", &T::leap_reach},
                                               {"leap_steps", &T::leap_steps},
                                               {"many", &T::many},
                                               {"tolerance", &T::tolerance},
                                               {"patience", &T::patience},
                                               {"progress", &T::progress, true}},
                                              own_tuning<T, SeparationSettings>, separated)};
}

Outcome tilted(const Marker& marker, const motion::tilting::TiltSettings& settings, SumCache& sums) {
  const auto done = tilt(marker, settings, {sums});
  return done ? Outcome{ratio_of(*done), false} : Outcome{.failed = true};
}

Family tilting_family() {
  using motion::tilting::TiltSettings;
  using motion::tilting::TiltStepTuning;
  using motion::tilting::TiltTuning;
  TiltSettings settings = tilt_settings(motion::tilting::TiltMethod::kLinearisation, Accuracy::kStandard);
  settings.limit = Angle::of_degrees(kTilt);
  Family family{"tilting", "the length after `tilt --limit 2`", as_it_is, {}};
  family.constants = constants_of<TiltTuning, TiltSettings>(settings,
                                                            {{"least_part", &TiltTuning::least_part},
                                                             {"corrections", &TiltTuning::corrections},
                                                             {"correction_turn", &TiltTuning::correction_turn},
                                                             {"separation_rounds", &TiltTuning::separation_rounds},
                                                             {"separation_growth", &TiltTuning::separation_growth},
                                                             {"perturbation_twist", &TiltTuning::perturbation_twist}},
                                                            own_tuning<TiltTuning, TiltSettings>, tilted);
  const auto of_steps = constants_of<TiltStepTuning, TiltSettings>(
      settings,
      {{"step.overlap_price", &TiltStepTuning::overlap_price},
       {"step.clearance", &TiltStepTuning::clearance},
       {"step.least_clearance", &TiltStepTuning::least_clearance},
       {"step.least_arc", &TiltStepTuning::least_arc},
       {"step.length_spare", &TiltStepTuning::length_spare}},
      [](TiltSettings& s) -> TiltStepTuning& { return s.tuning.step; }, tilted);
  family.constants.insert(family.constants.end(), of_steps.begin(), of_steps.end());
  return family;
}

// The marker with every position stretched by one per cent along the strip.
Marker roomy(const Marker& start, SumCache& /*sums*/) {
  Marker marker = start;
  for (Piece& piece : marker.pieces) piece.at.x += piece.at.x / 100;
  return marker;
}

// The narrowest gap is compared by its reciprocal: a narrower one is worse.
Outcome floated(const Marker& marker, const motion::floating::FloatSettings& settings, SumCache& sums) {
  motion::floating::FloatSettings wanted = settings;
  wanted.distance = marker.strip.width / 100;
  const auto done = float_apart(marker, wanted, {sums});
  if (!done || done->least_after <= 0) return {.failed = true};
  return {static_cast<double>(wanted.distance) / static_cast<double>(done->least_after), false};
}

Family floating_family() {
  using motion::floating::FloatSettings;
  using T = motion::floating::FloatTuning;
  return {
      "floating", "the reciprocal of the narrowest gap after `float`", roomy,
      constants_of<T, FloatSettings>(motion::floating::float_settings(motion::floating::FloatMode::kLargestMinimum, 1),
                                     {{"trust_ahead", &T::trust_ahead},
                                      {"least_trust", &T::least_trust},
                                      {"loaded", &T::loaded},
                                      {"rounding", &T::rounding}},
                                     own_tuning<T, FloatSettings>, floated)};
}

Outcome searched(const Marker& marker, const search::RefineSettings& settings, SumCache& sums) {
  const auto done = refine(marker, settings, {sums});
  return done ? Outcome{ratio_of(*done), false} : Outcome{.failed = true};
}

Family search_family() {
  using search::RefineSettings;
  using search::RefineTuning;
  using search::SwapTuning;
  RefineSettings settings = search::refine_settings();
  settings.effort = settings.least_effort = kSwaps;
  settings.nests = false;
  Family family{
      "search", "the length after the search of `fine`, without nesting and with an effort of 6,000", as_it_is, {}};
  family.constants =
      constants_of<RefineTuning, RefineSettings>(settings,
                                                 {{"compaction_rounds", &RefineTuning::compaction_rounds},
                                                  {"tilt_rounds", &RefineTuning::tilt_rounds},
                                                  {"tilt_within", &RefineTuning::tilt_within},
                                                  {"hope", &RefineTuning::hope},
                                                  {"turn", &RefineTuning::turn},
                                                  {"least_room", &RefineTuning::least_room},
                                                  {"idle_trials", &RefineTuning::idle_trials}},
                                                 own_tuning<RefineTuning, RefineSettings>, searched);
  const auto of_swaps = constants_of<SwapTuning, RefineSettings>(
      settings,
      {{"swap.turns_one_in", &SwapTuning::turns_one_in},
       {"swap.partners", &SwapTuning::partners},
       {"swap.distance_weight", &SwapTuning::distance_weight},
       {"swap.deepest", &SwapTuning::deepest},
       {"swap.deep_one_in", &SwapTuning::deep_one_in},
       {"swap.separation_rounds", &SwapTuning::separation_rounds},
       {"swap.separation_growth", &SwapTuning::separation_growth},
       {"swap.any_one_in", &SwapTuning::any_one_in}},
      [](RefineSettings& s) -> SwapTuning& { return s.tuning.swap; }, searched);
  family.constants.insert(family.constants.end(), of_swaps.begin(), of_swaps.end());
  return family;
}

// The mean of three seeds, because the result of a single search is a matter of luck.
Outcome nested(const Marker& marker, const nesting::NestSettings& settings, SumCache& sums) {
  double sum = 0;
  nesting::NestSettings seeded = settings;
  for (seeded.seed = 1; seeded.seed <= 3; ++seeded.seed) {
    const auto done = nest(marker, seeded, {sums});
    if (!done) return {.failed = true};
    sum += static_cast<double>(done->length_after);
  }
  return {sum / 3, false};
}

Family nesting_family() {
  using nesting::NestSettings;
  using nesting::NestTuning;
  using nesting::local_search::SearchTuning;
  using S = SearchTuning;
  NestSettings settings;
  settings.moves = kMoves;
  settings.from_scratch = true;
  Family family{"nesting", "the mean length of three nestings from nothing, of 6,000 moves each", as_it_is, {}};
  family.constants = constants_of<NestTuning, NestSettings>(settings,
                                                            {{"first_step", &NestTuning::first_step},
                                                             {"step_factor", &NestTuning::step_factor},
                                                             {"least_step", &NestTuning::least_step},
                                                             {"bold_patience", &NestTuning::bold_patience},
                                                             {"explored", &NestTuning::explored, true},
                                                             {"first_squeeze", &NestTuning::first_squeeze},
                                                             {"last_squeeze", &NestTuning::last_squeeze},
                                                             {"squeeze_patience", &NestTuning::squeeze_patience},
                                                             {"squeeze_strikes", &NestTuning::squeeze_strikes},
                                                             {"first_epoch", &NestTuning::first_epoch},
                                                             {"separation_rounds", &NestTuning::separation_rounds}},
                                                            own_tuning<NestTuning, NestSettings>, nested);
  const auto of_moves = constants_of<S, NestSettings>(
      settings,
      {{"search.charge", &S::charge},
       {"search.pixels_per_side", &S::pixels_per_side},
       {"search.tolerance", &S::tolerance},
       {"search.best_places", &S::best_places},
       {"search.rows_per_place", &S::rows_per_place},
       {"search.apart", &S::apart},
       {"search.stretch", &S::stretch},
       {"search.costly_fields", &S::costly_fields},
       {"search.hopeless", &S::hopeless},
       {"search.weight_growth", &S::weight_growth},
       {"search.extra_growth", &S::extra_growth},
       {"search.weight_decay", &S::weight_decay, true},
       {"search.progress", &S::progress, true},
       {"search.patience", &S::patience},
       {"search.strikes", &S::strikes}},
      [](NestSettings& s) -> S& { return s.tuning.search; }, nested);
  family.constants.insert(family.constants.end(), of_moves.begin(), of_moves.end());
  return family;
}

nesting::NestSettings of_one_start(std::uint64_t moves) {
  nesting::NestSettings settings;
  settings.moves = moves;
  settings.from_scratch = true;
  settings.tuning.raced_moves = moves;  // so the budget ends before another start
  return settings;
}

// Walks begin only after some ten thousand moves.
Family walks_family() {
  using nesting::NestSettings;
  using nesting::NestTuning;
  const NestSettings settings = of_one_start(10 * kMoves);
  return {"walks", "the mean length of three nestings from nothing, of 60,000 moves and one start each", as_it_is,
          constants_of<NestTuning, NestSettings>(settings,
                                                 {{"walk_slack", &NestTuning::walk_slack},
                                                  {"walk_moves", &NestTuning::walk_moves},
                                                  {"same_place", &NestTuning::same_place}},
                                                 own_tuning<NestTuning, NestSettings>, nested)};
}

// Turns are a tenth as long as usual, so that there are several of them.
Family turns_family() {
  using nesting::NestSettings;
  using nesting::NestTuning;
  NestSettings settings = of_one_start(25 * kMoves);
  settings.tuning.turn_moves /= 10;
  return {
      "turns",
      "the mean length of three nestings from nothing, of 150,000 moves and one start each, in turns of 20,000",
      as_it_is,
      constants_of<NestTuning, NestSettings>(
          settings,
          {{"turn_moves", &NestTuning::turn_moves}, {"pool", &NestTuning::pool}, {"pool_skew", &NestTuning::pool_skew}},
          own_tuning<NestTuning, NestSettings>, nested)};
}

}  // namespace

std::vector<Family> families() {
  return {compaction_family(), separation_family(), tilting_family(), floating_family(),
          search_family(),     nesting_family(),    walks_family(),   turns_family()};
}

}  // namespace selvage::bench::sensitivity
