#include "core/nesting/sheets/nest_on_sheets.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "core/nesting/layout/dice.h"
#include "core/nesting/sheets/costs.h"
#include "core/nesting/sheets/movable.h"
#include "core/nesting/sheets/used_sheet.h"
#include "core/nesting/sheets/worth.h"
#include "core/nesting/start/match_phases.h"
#include "core/nesting/timed_run.h"

namespace selvage::nesting::sheets {
namespace {

constexpr double kFirstPass = 0.5;           // part of the budget for the first filling of the sheets
constexpr double kUsual = 0.8;               // part of a sheet that pieces usually cover
constexpr double kTrial = 0.02;              // part of the budget for one exchange between sheets
constexpr std::uint64_t kLeast = 200;        // moves of a filling, and three for each piece, whatever the budget
constexpr std::size_t kMostOnSheet = 2'500;  // pieces; no more are offered to a sheet that has as many
constexpr std::size_t kFailures = 40;        // exchanges in a row that gain nothing, which end the search

using Indices = std::vector<std::size_t>;

// Those of `pieces` that are not among `others`, in order.
Indices without(const Indices& pieces, Indices others) {
  std::sort(others.begin(), others.end());
  Indices rest;
  for (const std::size_t piece : pieces) {
    if (!std::binary_search(others.begin(), others.end(), piece)) rest.push_back(piece);
  }
  return rest;
}

class Driver {
 public:
  // `run` is stopped when the time is used up, too; `caller`, the same without that, only by the caller.
  Driver(const Marker& marker, std::vector<Piece> pieces, std::vector<ReadySheet> sheets, const SheetSettings& settings,
         const scene::Run& run, const scene::Run& caller)
      : marker_{marker},
        pieces_{std::move(pieces)},
        sheets_{std::move(sheets)},
        settings_{settings},
        run_{run},
        caller_{caller},
        dice_{settings.seed},
        worth_{worth_of(marker, pieces_, settings.values)},
        costs_{sheets_},
        used_of_(sheets_.size()) {
    left_.resize(pieces_.size());
    std::iota(left_.begin(), left_.end(), 0U);
    std::stable_sort(left_.begin(), left_.end(),
                     [this](std::size_t a, std::size_t b) { return worth_.area[a] > worth_.area[b]; });
  }

  SheetNesting nested() {
    (void)lay_one_after_another();
    if (!used_.empty()) exchange(used_.size() - 1);
    keep_if_best();
    std::size_t failures = 0;
    while (!over() && failures < kFailures && (may_gain() || may_lay())) {
      const bool gained = left_.empty() ? empty_the_emptiest() : lay_on_free_sheets() || (may_gain() && bring_on());
      failures = gained ? 0 : failures + 1;
      keep_if_best();
    }
    const bool converged = failures >= kFailures || (!may_gain() && !may_lay());
    used_ = std::move(best_used_);
    left_ = std::move(best_left_);
    return result(converged);
  }

 private:
  [[nodiscard]] double spent(std::uint64_t more = 0) const {
    const auto moves = static_cast<double>(moves_ + more);
    const double part = settings_.moves == 0 ? 1 : moves / static_cast<double>(settings_.moves);
    return settings_.elapsed ? std::max(part, settings_.elapsed()) : part;
  }
  [[nodiscard]] bool over() const { return run_.stopped() || spent() >= 1; }
  [[nodiscard]] double area_of_all(const Indices& pieces) const {
    return std::accumulate(pieces.begin(), pieces.end(), 0.0,
                           [this](double sum, std::size_t i) { return sum + worth_.area[i]; });
  }

  // Fills a sheet until this part of the whole budget is spent.
  Filled fill_until(const UsedSheet& present, const Indices& more, const std::vector<double>& values, double until) {
    const std::uint64_t least = spent() < 1 ? kLeast + 3 * more.size() : 0;
    const auto over = [this, until, least](std::uint64_t moves) {
      return run_.stopped() || (moves >= least && spent(moves) >= until);
    };
    const FillTask task{marker_, pieces_, values, settings_.tuning, settings_.seed + ++fillings_, over};
    Filled done = filled(sheets_[present.kind], present, more, task, run_);
    moves_ += done.moves;
    programs_ += done.programs;
    return done;
  }

  // At most about kMostCandidates of the pieces that are left and fit the sheet, evenly from the large to the small
  // ones.
  [[nodiscard]] Indices candidates(std::size_t kind) const {
    Indices fitting;
    std::copy_if(left_.begin(), left_.end(), std::back_inserter(fitting),
                 [&](std::size_t piece) { return fits(piece, kind); });
    const std::size_t step = fitting.size() / kMostCandidates + 1;
    Indices chosen;
    for (std::size_t k = 0; k < fitting.size(); k += step) chosen.push_back(fitting[k]);
    return chosen;
  }

  // Pieces that have found no room on the free sheets are not tried there again.
  bool lay_on_free_sheets() {
    Indices wanted = left_;
    std::sort(wanted.begin(), wanted.end());
    if (!may_lay() || wanted == in_vain_) return false;
    if (lay_one_after_another()) return true;
    in_vain_ = std::move(wanted);
    return false;
  }

  // Lays pieces that are left over on sheets that are not used; false when none of them finds room.
  bool lay_one_after_another() {
    const std::size_t before = used_.size();
    for (const std::size_t kind : costs_.by_cost_per_area()) {
      while (used_of_[kind] < sheets_[kind].sheet->count && !left_.empty() && !caller_.stopped()) {
        const double now = spent();
        const double sheets = std::max(1.0, std::ceil(area_of_all(left_) / (kUsual * sheets_[kind].area)));
        const double until = now + std::max(0.0, kFirstPass - now) / sheets;
        UsedSheet used{.kind = kind, .pieces = {}, .placed = {}};
        // While all that is offered finds room, more is offered.
        for (bool room = true; room && !left_.empty() && used.pieces.size() < kMostOnSheet;) {
          const Indices offered = candidates(kind);
          if (offered.empty()) break;
          const std::size_t wanted = used.pieces.size() + offered.size();
          used = fill_until(used, offered, worth_.weight, until).used;
          room = used.pieces.size() == wanted;
          left_ = without(left_, used.pieces);
        }
        if (used.pieces.empty()) break;
        used_.push_back(std::move(used));
        ++used_of_[kind];
      }
    }
    return used_.size() > before;
  }

  // Free sheets that hold all pieces of a used one and cost less take its place.
  void exchange(std::size_t index) {
    if (!exchange_for_cheaper(index) && costs_.differ()) exchange_for_several(index);
  }

  // The cheapest free sheet that holds all pieces of a used one takes its place.
  bool exchange_for_cheaper(std::size_t index) {
    const UsedSheet used = used_[index];
    for (const std::size_t kind : costs_.by_cost()) {
      const ReadySheet& sheet = sheets_[kind];
      if (over() || !costs_.cheaper(kind, used.kind)) return false;
      if (used_of_[kind] == sheet.sheet->count || area_of_all(used.pieces) > sheet.area) continue;
      const Filled done =
          fill_until({.kind = kind, .pieces = {}, .placed = {}}, used.pieces, worth_.area, spent() + kTrial);
      if (done.used.pieces.size() < used.pieces.size()) continue;
      --used_of_[used.kind];
      ++used_of_[kind];
      used_[index] = done.used;
      return true;
    }
    return false;
  }

  // Several free sheets that cost less in all than a used one take its place.
  void exchange_for_several(std::size_t index) {
    Indices rest = used_[index].pieces;
    std::vector<UsedSheet> several;
    double cost = 0;
    for (const std::size_t kind : costs_.by_cost_per_area()) {
      const std::size_t free = sheets_[kind].sheet->count - used_of_[kind];
      for (std::size_t k = 0; k < free && !rest.empty() && cost + costs_.of(kind) < costs_.of(used_[index].kind); ++k) {
        if (over()) return;
        Filled done = fill_until({.kind = kind, .pieces = {}, .placed = {}}, rest, worth_.weight, spent() + kTrial);
        if (done.used.pieces.empty()) break;
        rest = without(rest, done.used.pieces);
        cost += costs_.of(kind);
        several.push_back(std::move(done.used));
      }
    }
    if (!rest.empty()) return;
    --used_of_[used_[index].kind];
    for (const UsedSheet& one : several) ++used_of_[one.kind];
    used_.erase(used_.begin() + static_cast<std::ptrdiff_t>(index));
    used_.insert(used_.end(), several.begin(), several.end());
  }

  [[nodiscard]] bool may_gain() const {
    if (!left_.empty()) {
      return std::any_of(left_.begin(), left_.end(), [this](std::size_t piece) {
        return std::any_of(used_.begin(), used_.end(), [&](const UsedSheet& used) { return fits(piece, used.kind); });
      });
    }
    return costs_.of(used_) > costs_.least_for(std::accumulate(worth_.area.begin(), worth_.area.end(), 0.0));
  }
  [[nodiscard]] bool fits(std::size_t piece, std::size_t kind) const { return sheets_[kind].fits[piece]; }
  // Whether a piece that is left over fits a sheet that is not used: it was taken off another one, or a filling ended
  // early.
  [[nodiscard]] bool may_lay() const {
    return std::any_of(costs_.by_cost_per_area().begin(), costs_.by_cost_per_area().end(), [this](std::size_t kind) {
      return used_of_[kind] < sheets_[kind].sheet->count &&
             std::any_of(left_.begin(), left_.end(), [&](std::size_t piece) { return fits(piece, kind); });
    });
  }

  // The least worth left over counts, then how little the sheets cost, then how few there are.
  void keep_if_best() {
    const std::tuple result{value_of(left_, worth_.value), costs_.of(used_), used_.size()};
    if (result > best_result_) return;
    best_result_ = result;
    best_used_ = used_;
    best_left_ = left_;
  }

  // Brings pieces that are left over onto a sheet, in place of others that count less.
  bool bring_on() {
    UsedSheet& used = used_[dice_.below(used_.size())];
    const double before = value_of(used.pieces, worth_.weight);
    const Filled done = fill_until(used, candidates(used.kind), worth_.weight, spent() + kTrial);
    if (done.value <= before) return false;
    Indices off = without(used.pieces, done.used.pieces);
    left_ = without(left_, done.used.pieces);
    left_.insert(left_.end(), off.begin(), off.end());
    used = done.used;
    return true;
  }

  // Moves area from the sheet that holds least for its cost to another one; a sheet that is empty then is no longer
  // used.
  bool empty_the_emptiest() {
    if (used_.size() < 2) return false;
    const auto by_content = [this](const UsedSheet& a, const UsedSheet& b) {
      return area_of_all(a.pieces) * costs_.of(b.kind) < area_of_all(b.pieces) * costs_.of(a.kind);
    };
    const auto emptiest =
        static_cast<std::size_t>(std::min_element(used_.begin(), used_.end(), by_content) - used_.begin());
    const std::size_t other = (emptiest + 1 + dice_.below(used_.size() - 1)) % used_.size();
    const double before = area_of_all(used_[other].pieces);
    const Filled fuller = fill_until(used_[other], used_[emptiest].pieces, worth_.area, spent() + kTrial);
    if (fuller.value <= before) return false;
    Indices rest = without(used_[emptiest].pieces, fuller.used.pieces);
    const Indices off = without(used_[other].pieces, fuller.used.pieces);
    rest.insert(rest.end(), off.begin(), off.end());
    const UsedSheet fresh{.kind = used_[emptiest].kind, .pieces = {}, .placed = {}};
    const Filled emptier = rest.empty() ? Filled{} : fill_until(fresh, rest, worth_.area, spent() + kTrial);
    if (emptier.used.pieces.size() < rest.size()) return false;
    used_[other] = fuller.used;
    used_[emptiest] = emptier.used;
    if (rest.empty()) {
      --used_of_[fresh.kind];
      used_.erase(used_.begin() + static_cast<std::ptrdiff_t>(emptiest));
    } else {
      exchange(emptiest);
    }
    return true;
  }

  [[nodiscard]] double value_of(const Indices& pieces, const std::vector<double>& values) const {
    return std::accumulate(pieces.begin(), pieces.end(), 0.0,
                           [&values](double sum, std::size_t i) { return sum + values[i]; });
  }

  [[nodiscard]] SheetNesting result(bool converged) {
    SheetNesting nesting{.layouts = {}, .left_over = {}, .moves = moves_, .programs = programs_};
    nesting.reason = converged ? scene::StopReason::kConverged : scene::StopReason::kWorkLimit;
    nesting.out_of_time = !converged && settings_.elapsed && settings_.elapsed() >= 1;
    for (const UsedSheet& used : used_) {
      SheetLayout layout{used.kind, sheets_[used.kind].area, sheets_[used.kind].bare};
      layout.marker.pieces.insert(layout.marker.pieces.end(), used.placed.begin(), used.placed.end());
      nesting.layouts.push_back(std::move(layout));
    }
    std::sort(left_.begin(), left_.end());
    for (const std::size_t piece : left_) {
      nesting.left_over.push_back(pieces_[piece]);
      nesting.left_over.back().at = {};
    }
    return nesting;
  }

  const Marker& marker_;
  std::vector<Piece> pieces_;
  std::vector<ReadySheet> sheets_;
  const SheetSettings& settings_;
  const scene::Run& run_;
  const scene::Run& caller_;
  layout::Dice dice_;
  Worth worth_;
  Costs costs_;
  Indices used_of_;  // how many sheets of each kind are used
  Indices left_;     // pieces that lie on no sheet
  Indices in_vain_;  // ascending; those that were last tried on the free sheets, without success
  std::vector<UsedSheet> used_, best_used_;
  Indices best_left_;
  std::tuple<double, double, std::size_t> best_result_{std::numeric_limits<double>::infinity(), 0, 0};
  std::uint64_t moves_{}, fillings_{};
  int programs_{};
};

// Nests the pieces of a marker without match sets.
Result<SheetNesting> nest_pieces_on_sheets(const Marker& start, std::span<const Sheet> sheets,
                                           const SheetSettings& settings, const scene::Run& run) {
  if (start.pieces.empty() && start.unplaced.empty()) {
    return Error{ErrorCode::kEmptyMarker, "the marker has no piece", "/pieces"};
  }
  if (const auto refusal = unmovable(start.pieces, "/pieces/")) return *refusal;
  if (const auto refusal = unmovable(start.unplaced, "/unplaced/")) return *refusal;
  std::vector<Piece> pieces = start.pieces;
  pieces.insert(pieces.end(), start.unplaced.begin(), start.unplaced.end());
  std::vector<ReadySheet> kinds;
  for (const Sheet& sheet : sheets) {
    if (run.stopped()) break;  // the others are not used
    auto made = ready(start, pieces, sheet, run.sums);
    if (!made) {
      Error error = made.error();
      error.field = "/sheets/" + std::to_string(kinds.size()) + error.field;
      return error;
    }
    kinds.push_back(*std::move(made));
  }
  const TimedRun timed{run, settings.elapsed};
  SheetNesting nesting = Driver{start, std::move(pieces), std::move(kinds), settings, timed.run(), run}.nested();
  if (run.stopped()) nesting.reason = scene::StopReason::kCancelled;
  return nesting;
}

}  // namespace

Result<SheetNesting> nest_on_sheets(const Marker& start, std::span<const Sheet> sheets, const SheetSettings& settings,
                                    const scene::Run& run) {
  const auto matched = start::with_sets_matched_to_cloth(start);
  if (!matched) return nest_pieces_on_sheets(start, sheets, settings, run);
  auto nesting = nest_pieces_on_sheets(*matched, sheets, settings, run);
  if (!nesting) return nesting;
  for (SheetLayout& layout : nesting->layouts) start::give_back_rules(layout.marker, start);
  Marker left;
  left.unplaced = std::move(nesting->left_over);
  start::give_back_rules(left, start);
  nesting->left_over = std::move(left.unplaced);
  return nesting;
}

}  // namespace selvage::nesting::sheets
