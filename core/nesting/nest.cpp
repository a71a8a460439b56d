#include "core/nesting/nest.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/marker/validity.h"
#include "core/motion/piece/sweep.h"
#include "core/nesting/batches/batch_share.h"
#include "core/nesting/best_of_all.h"
#include "core/nesting/cloth_end.h"
#include "core/nesting/filling/lying.h"
#include "core/nesting/finish.h"
#include "core/nesting/layout/layout.h"
#include "core/nesting/race.h"
#include "core/nesting/start/first_layout.h"
#include "core/nesting/start/fixed_pieces.h"
#include "core/nesting/start/match_phases.h"
#include "core/nesting/timed_run.h"
#include "core/scene/scene.h"

namespace selvage::nesting {
namespace {

// What a piece is worth where the cloth ends: what the caller says, else its area.
std::vector<double> values_of(const Marker& start, const layout::PieceSet& set, const NestSettings& settings) {
  std::vector<double> values;
  for (const auto* pieces : {&start.pieces, &start.unplaced}) {
    for (const Piece& piece : *pieces) {
      const auto given = settings.values.find(piece.id);
      const double area = set.kind(values.size()).area * set.lattice_units * set.lattice_units;
      values.push_back(given != settings.values.end() ? given->second : piece.rules.zone ? 0 : area);
    }
  }
  return values;
}

// The task of every search.
struct Task {
  const Marker& start;  // the fixed pieces, and others where they lie
  const Marker& first;  // all pieces, valid on an endless strip
  const layout::PieceSet& set;
  const NestSettings& settings;
  std::vector<double> values;  // by piece
};

// By piece: whether it stays where the first marker has it, as long as no search moves it.
std::vector<bool> staying(const Task& task) {
  Marker endless = task.start;
  endless.strip = task.start.strip.ending(std::nullopt);
  std::vector<bool> stay = start::kept_where_valid(endless, task.set);
  stay.resize(task.set.size());
  return stay;
}

struct Searched {
  filling::Filling best;
  Coord length{};  // of all pieces on an endless strip
  std::vector<Improvement> history{};
  std::uint64_t moves{};
  int programs{};
  bool converged{}, out_of_time{};
};

// Where pieces are left over, those that lie should be worth most; then the marker should be short.
bool better(const Searched& a, const Searched& b) {
  return a.best.value != b.best.value ? a.best.value > b.best.value : a.length < b.length;
}

Searched at_cloth_end(Searched searched, const Task& task, const Budget& budget, std::uint64_t seed,
                      const scene::Run& run) {
  searched.best.marker.strip = task.start.strip;
  const AtClothEnd at{task.set, task.values, task.settings.tuning, budget, searched.moves, seed};
  searched.best = end_with_cloth(std::move(searched.best.marker), at, run);
  searched.moves += searched.best.moves;
  searched.programs += searched.best.programs;
  return searched;
}

Result<Nesting> nest_alone(const Marker& given, const NestSettings& settings, const scene::Run& run);

// Slides every piece to the left, one after another.
Marker swept(const Marker& marker, const scene::Run& run) {
  scene::Scene scene{marker, run.sums};
  int sweeps = 0;
  (void)motion::piece::sweep_until_still(scene, {.sweeps = 1}, run.quiet(), sweeps);
  return scene.result();
}

// Instead of a search, when there are too many pieces for one.
Searched search_in_batches(const Task& task, const Budget& budget, const std::function<double()>& elapsed,
                           const scene::Run& run, BestOfAll& best_of_all) {
  const NestSettings& settings = task.settings;
  Searched searched{.best = {.marker = task.first}, .length = length_of(task.first)};
  const auto over = [&] { return budget.over(searched.moves); };
  const auto nest_batch = [&](const Marker& batch, std::size_t left) -> std::optional<Marker> {
    const std::uint64_t rest = settings.moves - std::min(settings.moves, searched.moves);
    batches::BatchShare share{rest, elapsed, batch.unplaced.size(), left};
    NestSettings own{.moves = share.moves(), .seed = settings.seed + left, .tilts = settings.tilts};
    own.tuning = settings.tuning;
    if (!over()) own.tuning.most_pieces = std::max(own.tuning.most_pieces, batch.pieces.size() + batch.unplaced.size());
    if (elapsed) own.elapsed = [&share] { return share.used(); };
    scene::Run within = run;
    within.observer.on_round = [&share](const scene::Round&) { share.found_better(); };
    auto nested = nest_alone(batch, own, within);
    if (!nested) return std::nullopt;
    searched.moves += nested->moves;
    searched.programs += nested->programs;
    return std::move(nested->marker);
  };
  if (!over()) {
    const std::vector<bool> stay = staying(task);
    auto marker = batches::nested_in_batches(task.first, stay, settings.tuning.batches, nest_batch, over);
    if (!marker) marker = swept(task.first, run);
    if (const Coord length = length_of(*marker); length < searched.length) {
      searched.best.marker = *std::move(marker);
      searched.length = length;
      searched.history.push_back({searched.moves, length});
      best_of_all.offer(searched.history.back(), searched.best.marker);
    }
  }
  return at_cloth_end(std::move(searched), task, budget, settings.seed, run);
}

std::optional<ClothEnd> cloth_end(const Task& task) {
  const auto last = task.start.strip.last();
  if (!last) return std::nullopt;
  const layout::PieceSet& set = task.set;
  const double cloth = (static_cast<double>(*last) / set.lattice_units - set.left) * set.across();
  const NestTuning& tuning = task.settings.tuning;
  return ClothEnd{*last, set.area < cloth ? tuning.end_patience : tuning.hopeless_patience};
}

// True when some pieces that may move lie somewhere.
bool has_layout(const Task& task) {
  const auto& fixed = task.set.fixed;
  return std::count(fixed.begin(), fixed.end(), true) < static_cast<std::ptrdiff_t>(task.start.pieces.size());
}

// Every search has its own seed, and starts from the pieces where they lie or, every other one, from scratch.  Starts
// race where no layout is given and the cloth does not end.
Searched search(std::size_t number, const Task& task, const Budget& budget, const scene::Run& run,
                BestOfAll& best_of_all) {
  const NestTuning& tuning = task.settings.tuning;
  const std::uint64_t seed = task.settings.seed + number;
  const auto end = cloth_end(task);
  Searched searched;
  searched.length = kLatticeLimit;
  const auto on_better = [&](const Improvement& improvement, const Marker& marker) {
    if (improvement.length >= searched.length) return;
    searched.length = improvement.length;
    searched.history.push_back(improvement);
    best_of_all.offer(improvement, marker);
  };
  Exploration::Shorter shorter;
  if (task.settings.searches > 1 && budget.timed()) {
    shorter = [&](Coord length) { return best_of_all.shorter_than(length); };
  }
  std::vector<bool> kept = task.set.fixed;
  for (std::size_t i = 0; i < task.start.pieces.size() && number % 2 == 0; ++i) kept[i] = true;
  Marker from = task.first;
  std::copy(task.start.pieces.begin(), task.start.pieces.end(), from.pieces.begin());
  local_search::GuidedSearch guided{task.set, seed, tuning.map_bytes, tuning.search,
                                    [&budget] { return budget.out_of_time(); }};
  const auto begin = [&](OnStall on_stall) {
    auto exploration = std::make_unique<Exploration>(task.set, task.first, guided, tuning, on_stall, budget, end, run,
                                                     on_better, shorter);
    exploration->begin(to_layout(task.set, from), kept);
    return exploration;
  };
  std::unique_ptr<Exploration> best;
  if (end || has_layout(task)) {
    best = begin(OnStall::kTakeTurns);
    best->advance(std::numeric_limits<std::uint64_t>::max());
  } else {
    const Race::Terms terms{tuning.raced_moves, tuning.least_raced_in_time, tuning.most_raced_in_time, tuning.raced,
                            tuning.raced_gain};
    Race race{begin, terms, budget};
    best = race.run(guided);
    searched.programs = race.programs();
  }
  searched.best.marker = best->best();
  searched.length = best->length();
  searched.moves = guided.moves();
  searched.programs += best->programs();
  searched.converged = best->converged();
  return at_cloth_end(std::move(searched), task, budget, seed, run);
}

// The marker that is nested, and its pieces as the search sees them.
struct Start {
  Marker marker;  // the fixed pieces, and others where they lie
  layout::PieceSet set;
};

Result<Start> start_of(const Marker& given, const NestSettings& settings, minkowski::SumCache& sums) {
  if (given.pieces.empty() && given.unplaced.empty()) {
    return Error{ErrorCode::kEmptyMarker, "the marker has no piece", "/pieces"};
  }
  auto set = piece_set_of(given, settings.placed, sums);
  if (!set) return set.error();
  Start start{given, std::move(*set)};
  if (settings.from_scratch) {
    start.marker = start::with_pieces_taken_off(given, start.set);
    set = piece_set_of(start.marker, settings.placed, sums);
    if (!set) return set.error();
    start.set = std::move(*set);
  }
  if (auto defect = marker::defect_of_fixed(start.marker, start.set.fixed)) return *std::move(defect);
  return start;
}

// All pieces on an endless strip, valid: what every search improves on.
Result<Marker> first_marker(const Start& start, const NestSettings& settings, const scene::Run& run) {
  Marker endless = start.marker;
  endless.strip = start.marker.strip.ending(std::nullopt);
  const TimedRun timed{run, settings.elapsed};
  const NestTuning& tuning = settings.tuning;
  const Budget budget{0, settings.elapsed, run.stop, tuning.explored, tuning.first_epoch};
  const start::FirstLayoutSettings first{.seed = settings.seed,
                                         .map_bytes = tuning.map_bytes,
                                         .most_pieces = tuning.most_pieces,
                                         .separation_rounds = tuning.separation_rounds,
                                         .search = tuning.search,
                                         .out_of_time = [&budget] { return budget.out_of_time(); }};
  return start::first_layout(endless, start.set, start::kept_where_valid(endless, start.set), first,
                             timed.run().quiet());
}

// The settings of each search, which has its share of the memory for maps.
NestSettings of_each_search(NestSettings settings) {
  NestTuning& tuning = settings.tuning;
  tuning.map_bytes = std::min(tuning.map_bytes, tuning.all_map_bytes / std::max<std::size_t>(1, settings.searches));
  return settings;
}

// All searches.  With a limit on moves they share nothing but what they report, so any number of threads gives the same
// results; late in a time limit they go on from the best marker of all.
std::vector<Searched> search_all(const Task& task, const std::function<double()>& elapsed, const scene::Run& run,
                                 BestOfAll& best_of_all) {
  const NestTuning& tuning = task.settings.tuning;
  const bool too_many = task.set.size() > tuning.most_pieces;
  std::vector<std::optional<Searched>> searched(too_many ? 1 : std::max<std::size_t>(1, task.settings.searches));
  run.executor->for_each(searched.size(), [&](std::size_t k) {
    const scene::Run own = searched.size() == 1 ? run : scene::Run{run.sums, run.stop};
    const TimedRun timed{own, elapsed};
    const Budget budget{task.settings.moves, elapsed, run.stop, tuning.explored, tuning.first_epoch};
    searched[k] = too_many ? search_in_batches(task, budget, elapsed, timed.run(), best_of_all)
                           : search(k, task, budget, timed.run(), best_of_all);
    searched[k]->out_of_time = budget.out_of_time();
  });
  std::vector<Searched> all;
  for (auto& one : searched) all.push_back(*std::move(one));
  return all;
}

// The best of the searches, with the work of all of them.
Nesting best_of(std::vector<Searched>& searched) {
  const auto best = std::min_element(searched.begin(), searched.end(), better);
  Nesting nesting;
  nesting.search = static_cast<std::size_t>(best - searched.begin());
  for (const Searched& one : searched) {
    nesting.moves += one.moves;
    nesting.programs += one.programs;
  }
  nesting.history = std::move(best->history);
  nesting.rounds = static_cast<int>(nesting.history.size());
  nesting.marker = filling::with_lying_pieces(best->best.marker, best->best.lies);
  nesting.left_over = nesting.marker.unplaced.size();
  nesting.reason = best->converged ? scene::StopReason::kConverged : scene::StopReason::kWorkLimit;
  nesting.out_of_time = !best->converged && best->out_of_time;
  return nesting;
}

// Nests a marker without match sets.
Result<Nesting> nest_alone(const Marker& given, const NestSettings& settings, const scene::Run& run) {
  auto start = start_of(given, settings, run.sums);
  if (!start) return start.error();
  const auto first = first_marker(*start, settings, run);
  if (!first) return first.error();

  const bool searched_at_once =
      start->set.size() <= settings.tuning.most_pieces;  // batches tilt their pieces themselves
  const bool tilts = settings.tilts && settings.moves > 0 && searched_at_once && may_tilt(start->marker);
  std::function<double()> elapsed = settings.elapsed;  // while pieces keep their tilts
  if (elapsed && tilts) elapsed = [&settings] { return settings.elapsed() / settings.tuning.searched; };
  BestOfAll best_of_all{run.observer, kLatticeLimit};
  const NestSettings of_search = of_each_search(settings);
  const Task task{start->marker, *first, start->set, of_search, values_of(start->marker, start->set, settings)};
  auto searched = search_all(task, elapsed, run, best_of_all);

  Nesting nesting = best_of(searched);
  if (tilts && nesting.left_over == 0 && !run.stopped()) {
    if (auto finish = finished(nesting.marker, start->set.fixed, settings.elapsed, run)) {
      nesting.marker = std::move(finish->marker);
      nesting.programs += finish->programs;
      best_of_all.offer({nesting.moves, finish->length}, nesting.marker);
    }
  }
  nesting.length_before = length_of(given);
  nesting.length_after = length_of(nesting.marker);
  if (nesting.reason != scene::StopReason::kConverged && run.stopped()) nesting.reason = scene::StopReason::kCancelled;
  return nesting;
}

}  // namespace

Result<Nesting> nest(const Marker& start, const NestSettings& settings, const scene::Run& run) {
  const auto matched = start::with_sets_matched_to_cloth(start);
  if (!matched) return nest_alone(start, settings, run);
  scene::Run own = run;
  own.observer.on_round = [&](scene::Round round) {
    std::optional<Marker> as_given;
    if (round.marker) start::give_back_rules(as_given.emplace(*round.marker), start);
    if (as_given) round.marker = &*as_given;
    run.observer.on_round(round);
  };
  auto nesting = nest_alone(*matched, settings, own);
  if (nesting) start::give_back_rules(nesting->marker, start);
  return nesting;
}

}  // namespace selvage::nesting
