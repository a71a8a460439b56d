#include "core/planning/cheapest/annealing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

#include "core/planning/program/plies.h"

namespace selvage::planning::cheapest {
namespace {

using orders::Ratio;
using program::Cutting;
using program::Use;

// Temperatures at the beginning and at the end, and the price of a garment too few or too many: parts of the scale, the
// last one for each garment that is ordered.
constexpr double kHottest = 4e-3, kColdest = 1e-4, kMisfit = 2.5;
constexpr int kStride = 4;      // of a larger change of plies, besides changes by one unit
constexpr int kDescents = 60;   // most changes of the plies of a colour in a step
constexpr int kStopEvery = 64;  // steps between two looks at the stop token

struct Slot {
  Candidate candidate;
  double unit{}, lay{};  // prices
};
struct State {
  std::vector<Slot> slots;
  std::vector<int> units;      // by slot, by colour
  std::vector<int> delivered;  // by colour, by size; in units of plies
};

class Annealer {
 public:
  Annealer(const orders::Problem& problem, const Lengths& lengths, const AnnealingSettings& settings)
      : problem_{problem},
        lengths_{lengths},
        settings_{settings},
        colours_{problem.order.colours.size()},
        sizes_{problem.order.sizes.size()},
        random_{settings.seed} {
    std::int64_t garments = 0;  // as many as a unit of plies cuts count as one
    for (std::size_t colour = 0; colour < colours_; ++colour) {
      windows_.push_back(program::window_of(problem, colour));
      for (const int least : windows_.back().least) garments += least;
    }
    misfit_price_ = kMisfit * settings.scale / static_cast<double>(std::max<std::int64_t>(1, garments));
  }

  std::optional<Cutting> run(const std::stop_token& stop) {
    now_ = first_state();
    double cost = cost_of_state(now_);
    for (int step = 0; step < settings_.steps; ++step) {
      if (step % kStopEvery == 0 && stop.stop_requested()) break;
      const double done = static_cast<double>(step) / settings_.steps;
      const double temperature = settings_.scale * kHottest * std::pow(kColdest / kHottest, done);
      next_ = now_;
      if (!change(next_)) continue;
      for (std::size_t colour = 0; colour < colours_; ++colour) descend(next_, colour);
      const double next_cost = cost_of_state(next_);
      if (next_cost > cost && part() >= std::exp((cost - next_cost) / temperature)) continue;
      std::swap(now_, next_);
      cost = next_cost;
      keep_if_best(cost);
    }
    return std::move(best_);
  }

 private:
  std::size_t below(std::size_t count) { return random_() % count; }
  double part() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  // By how many garments this is too few or too many.
  [[nodiscard]] int outside(std::size_t colour, std::size_t size, int delivered) const {
    const program::Window& window = windows_[colour];
    return std::max({0, window.least[size] - delivered, delivered - window.most[size]});
  }
  [[nodiscard]] std::int64_t outside(const State& state) const {
    std::int64_t sum = 0;
    for (std::size_t colour = 0; colour < colours_; ++colour) {
      for (std::size_t size = 0; size < sizes_; ++size)
        sum += outside(colour, size, state.delivered[colour * sizes_ + size]);
    }
    return sum;
  }

  [[nodiscard]] double cost_of_state(const State& state) const {
    double cost = 0;
    for (std::size_t k = 0; k < state.slots.size(); ++k) {
      int units = 0;
      for (std::size_t colour = 0; colour < colours_; ++colour) units += state.units[k * colours_ + colour];
      if (units == 0) continue;
      const int lays = (units + problem_.units_of_lay() - 1) / problem_.units_of_lay();
      cost += state.slots[k].unit * units + state.slots[k].lay * lays + problem_.costs.marker;
    }
    return cost + misfit_price_ * static_cast<double>(outside(state));
  }

  [[nodiscard]] Slot slot_of(Candidate candidate) const {
    const program::Price price = program::price_of(problem_, candidate);
    return {std::move(candidate), price.unit, price.lay};
  }

  // A candidate of bundles that are drawn at random.
  std::optional<Candidate> drawn_candidate() {
    if (lengths_.made_only) return candidate_of(problem_, lengths_, lengths_.made[below(lengths_.made.size())].ratio);
    const auto most = static_cast<std::size_t>(problem_.limits.bundles);
    const std::size_t bundles = below(2) == 0 ? most : 1 + below(most);
    Ratio ratio(sizes_);
    for (std::size_t k = 0; k < bundles; ++k) ++ratio[below(sizes_)];
    return candidate_of(problem_, lengths_, ratio);
  }

  State first_state() {
    constexpr int kDraws = 200;
    State state;
    for (int draw = 0; draw < kDraws && state.slots.size() < settings_.markers; ++draw) {
      if (auto candidate = drawn_candidate()) state.slots.push_back(slot_of(*std::move(candidate)));
    }
    state.units.assign(state.slots.size() * colours_, 0);
    state.delivered.assign(colours_ * sizes_, 0);
    if (state.slots.empty()) return state;
    for (std::size_t colour = 0; colour < colours_; ++colour) descend(state, colour);
    return state;
  }

  void add_units(State& state, std::size_t slot, std::size_t colour, int units) const {
    state.units[slot * colours_ + colour] += units;
    const Ratio& ratio = state.slots[slot].candidate.ratio;
    for (std::size_t size = 0; size < sizes_; ++size) state.delivered[colour * sizes_ + size] += units * ratio[size];
  }

  void replace(State& state, std::size_t slot, Candidate candidate, bool keep_plies) const {
    for (std::size_t colour = 0; colour < colours_; ++colour) {
      const int units = state.units[slot * colours_ + colour];
      const Ratio& old = state.slots[slot].candidate.ratio;
      if (!keep_plies) {
        add_units(state, slot, colour, -units);
        continue;
      }
      for (std::size_t size = 0; size < sizes_; ++size)
        state.delivered[colour * sizes_ + size] += units * (candidate.ratio[size] - old[size]);
    }
    state.slots[slot] = slot_of(std::move(candidate));
  }

  // One bundle more, one fewer, or one of another size.  False when such a marker may not be cut.
  bool change_ratio(State& state, std::size_t slot) {
    Ratio ratio = state.slots[slot].candidate.ratio;
    const int bundles = orders::bundles_in(ratio);
    const std::size_t from = below(sizes_), to = below(sizes_), kind = below(3);
    if (kind == 0 ? bundles == problem_.limits.bundles : ratio[from] == 0 || from == to) return false;
    if (kind == 1 && bundles == 1) return false;
    if (kind != 0) --ratio[from];
    if (kind != 1) ++ratio[to];
    auto candidate = candidate_of(problem_, lengths_, ratio);
    if (!candidate) return false;
    replace(state, slot, *std::move(candidate), true);
    return true;
  }

  // False when nothing has changed.
  bool change(State& state) {
    if (state.slots.empty()) return false;
    const std::size_t slot = below(state.slots.size()), kind = below(10);
    if (kind < 6) return change_ratio(state, slot);
    if (kind < 8) {
      const bool first = change_ratio(state, slot);
      return change_ratio(state, below(state.slots.size())) || first;
    }
    if (kind == 8) {
      auto candidate = drawn_candidate();
      if (!candidate) return false;
      replace(state, slot, *std::move(candidate), false);
      return true;
    }
    const std::size_t colour = below(colours_);
    const int by = static_cast<int>(below(7)) - 3;
    if (state.units[slot * colours_ + colour] + by < 0) return false;
    add_units(state, slot, colour, by);
    return true;
  }

  // A change of the units of one or two slots in a colour.
  struct Change {
    std::size_t first{}, second{};
    int by{}, second_by{};
  };

  // What the plies of the colour cost, lays left out, after the change; relative to no plies at all.
  [[nodiscard]] double cost_after(const State& state, std::size_t colour, const Change& change) const {
    const Slot &first = state.slots[change.first], &second = state.slots[change.second];
    int misfit = 0;
    for (std::size_t size = 0; size < sizes_; ++size) {
      const int more = change.by * first.candidate.ratio[size] + change.second_by * second.candidate.ratio[size];
      misfit += outside(colour, size, state.delivered[colour * sizes_ + size] + more);
    }
    return misfit_price_ * misfit + change.by * first.unit + change.second_by * second.unit;
  }

  // Changes the plies of the colour while that makes it cheaper, always by the change that does most.
  void descend(State& state, std::size_t colour) const {
    const std::size_t count = state.slots.size();
    const auto units = [&](std::size_t slot) { return state.units[slot * colours_ + colour]; };
    for (int round = 0; round < kDescents; ++round) {
      Change best;
      double least = cost_after(state, colour, {}) - 1e-9 * misfit_price_;
      const auto look_at = [&](const Change& change) {
        const double cost = cost_after(state, colour, change);
        if (cost >= least) return;
        least = cost;
        best = change;
      };
      for (std::size_t first = 0; first < count; ++first) {
        for (const int by : {-1, 1, -kStride, kStride}) {
          if (units(first) + by >= 0) look_at({first, first, by, 0});
        }
        for (std::size_t second = first + 1; second < count; ++second) {
          for (const auto& [by, second_by] : {std::pair{-1, -1}, {-1, 1}, {1, -1}, {1, 1}}) {
            if (units(first) + by >= 0 && units(second) + second_by >= 0) look_at({first, second, by, second_by});
          }
        }
      }
      if (best.by == 0) return;
      add_units(state, best.first, colour, best.by);
      if (best.second_by != 0) add_units(state, best.second, colour, best.second_by);
    }
  }

  void keep_if_best(double cost) {
    if ((best_ && cost >= best_->cost) || outside(now_) > 0) return;
    Cutting cutting;
    for (std::size_t k = 0; k < now_.slots.size(); ++k) add_use(cutting.uses, k);
    std::sort(cutting.uses.begin(), cutting.uses.end(),
              [](const Use& a, const Use& b) { return a.candidate.ratio < b.candidate.ratio; });
    cutting.cost = program::cost_of(problem_, cutting.uses);
    if (program::delivers(problem_, cutting.uses) && (!best_ || cutting.cost < best_->cost)) best_ = std::move(cutting);
  }

  // The slot as a use, if it has plies; slots of the same ratio become one use.
  void add_use(std::vector<Use>& uses, std::size_t slot) const {
    const auto begin = now_.units.begin() + static_cast<std::ptrdiff_t>(slot * colours_);
    const std::vector<int> units(begin, begin + static_cast<std::ptrdiff_t>(colours_));
    if (std::all_of(units.begin(), units.end(), [](int count) { return count == 0; })) return;
    const Candidate& candidate = now_.slots[slot].candidate;
    const auto same =
        std::find_if(uses.begin(), uses.end(), [&](const Use& use) { return use.candidate.ratio == candidate.ratio; });
    if (same == uses.end()) {
      uses.push_back({candidate, units});
      return;
    }
    for (std::size_t colour = 0; colour < colours_; ++colour) same->units[colour] += units[colour];
  }

  const orders::Problem& problem_;
  const Lengths& lengths_;
  const AnnealingSettings& settings_;
  std::size_t colours_, sizes_;
  std::mt19937_64 random_;
  std::vector<program::Window> windows_;  // by colour
  double misfit_price_{};
  State now_, next_;
  std::optional<Cutting> best_;
};

}  // namespace

std::optional<Cutting> anneal(const orders::Problem& problem, const Lengths& lengths, const AnnealingSettings& settings,
                              std::stop_token stop) {
  if (lengths.made_only && lengths.made.empty()) return std::nullopt;
  return Annealer{problem, lengths, settings}.run(stop);
}

}  // namespace selvage::planning::cheapest
