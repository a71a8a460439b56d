#include "core/motion/separation/separation_step.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/position_model.h"
#include "core/model/snap.h"

namespace selvage::motion::separation {
namespace {

constexpr double kDisplacementPenalty = 1;  // the unit of all prices: a piece moving by one unit on one axis

class SeparationProgram {
 public:
  SeparationProgram(const scene::Scene& scene, const model::ActiveSet& reached, const SeparationStepSettings& settings)
      : scene_{scene},
        reached_{reached},
        settings_{settings},
        length_{scene.pieces.length()},
        model_{scene.pieces, scene.marker.strip.ending({}), reached.with_others_fixed()} {}

  void add_length() {
    const LengthAllowance& allowance = settings_.length;
    const Coord shorten = std::max(Coord{0}, length_ - allowance.free);
    model_.add_length(allowance.price, static_cast<double>(shorten), lp::kInfinity);
    const int length_column = model_.program().columns() - 1;
    const int excess = model_.program().add_column(allowance.excess_price, 0, lp::kInfinity);
    // excess >= length - allowed
    const double room = model_.unit().to_columns(static_cast<double>(allowance.allowed - length_));
    model_.program().add_row(std::array<lp::LinearProgram::Entry, 2>{{{excess, 1}, {length_column, -1}}}, -room);
    const double watched = static_cast<double>(length_ - shorten) - 2 * settings_.reach;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (static_cast<double>(scene_.pieces.end_of(i)) >= watched) model_.add_right_wall(i);
    }
  }

  // `near`: the pairs that may come into contact.  Both lists are sorted.  When cancelled, only some rows are added.
  void add_pairs(const std::vector<OverlappingPair>& overlapping, const std::vector<marker::PiecePair>& near,
                 const std::stop_token& stop) {
    auto overlap = overlapping.begin();
    for (const marker::PiecePair& pair : near) {
      if (stop.stop_requested()) return;
      const bool overlaps = overlap != overlapping.end() && overlap->pair == pair;
      if (overlaps) {
        add_pair(pair, overlap->target.about, overlap->price, stop);
        ++overlap;
      } else if (reached_.holds_any(pair)) {
        add_pair(pair, scene_.relative_position(pair), settings_.price, stop);
      }
    }
  }

  void add_displacement_penalty(const std::vector<Vec>& home) {
    model_.add_displacement_penalty(kDisplacementPenalty, home);
  }

  [[nodiscard]] lp::LpSolution solved(const scene::Run& run) const {
    lp::solver::LpLimits limits;
    limits.tolerance = settings_.tolerance;
    limits.reach = model_.reach();
    return solve(model_.program(), settings_.solver, limits, run.stop, *run.executor);
  }
  // The pieces without columns that would move in the solution if they had columns.
  [[nodiscard]] std::vector<std::uint32_t> missed(const lp::LpSolution& solution) const {
    model::Pressure pressure{scene_.pieces.size()};
    for (const auto& [row, pair_row] : rows_) pressure.add(pair_row, solution.dual[static_cast<std::size_t>(row)]);
    pressure.add_shades(model_, solution.dual);
    const Strip& strip = scene_.marker.strip;
    return reached_.missed(scene_.pieces, pressure.load(), kDisplacementPenalty, strip,
                           strip.last().value_or(kLatticeLimit));
  }
  void take(const lp::LpSolution& solution, SeparationStep& step) const {
    step.positions = model::snapped(model_.displacements(solution.x));
    for (std::size_t i = 0; i < step.positions.size(); ++i) step.positions[i] = step.positions[i] + scene_.pieces.at(i);
    step.pressure.assign(scene_.pieces.size(), 0);
    for (const auto& [row, pair_row] : rows_) {
      step.pressure[pair_row.pair.first] += solution.dual[static_cast<std::size_t>(row)];
      step.pressure[pair_row.pair.second] += solution.dual[static_cast<std::size_t>(row)];
    }
  }

  [[nodiscard]] const lp::LinearProgram& program() const { return model_.program(); }

 private:
  // The rows of one pair, none when cancelled; those that its present position violates may all stay violated by the
  // same amount.
  void add_pair(marker::PiecePair pair, Vec about, double price, const std::stop_token& stop) {
    if (scene_.ties.joined(pair.first, pair.second)) return;
    const Coord spacing = scene_.pieces.spacing(pair);
    const Vec r = scene_.relative_position(pair);
    const auto obstacle = scene_.obstacle(pair, stop);
    if (!obstacle) return;
    const auto rows = pair_rows(pair, {*obstacle, r, about, spacing}, model::region_within(settings_.reach, spacing),
                                {model_.unit(), settings_.tight});
    std::optional<int> give;
    if (std::any_of(rows.begin(), rows.end(), [](const model::PairRow& row) { return row.bound > 0; })) {
      give = model_.program().add_column(price, 0, lp::kInfinity);
    }
    for (const model::PairRow& row : rows) {
      if (const auto added = model_.add(row, row.bound > 0 ? give : std::nullopt)) rows_.emplace_back(*added, row);
    }
  }

  const scene::Scene& scene_;
  const model::ActiveSet& reached_;
  const SeparationStepSettings& settings_;
  Coord length_;
  model::PositionModel model_;
  std::vector<std::pair<int, model::PairRow>> rows_;  // rows of the program, and the pairs they are of
};

// The pieces that have a reason of their own to move.
model::ActiveSet moving(const scene::Scene& scene, const std::vector<OverlappingPair>& overlapping,
                        const std::vector<Vec>& home, const SeparationStepSettings& settings) {
  model::ActiveSet reached{with_match_sets(scene.ties, scene.pieces, scene.marker.strip)};
  for (const OverlappingPair& overlap : overlapping) {
    reached.add(overlap.pair.first);
    reached.add(overlap.pair.second);
  }
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
    const bool beyond = scene.pieces.end_of(i) > settings.length.free;
    if (beyond || scene.pieces.at(i) != home[i]) reached.add(i);
  }
  for (const marker::Shade& shade : scene.pieces.shades()) {
    if (scene.pieces.excess_of(shade) <= 0) continue;
    for (const std::uint32_t piece : shade.pieces) reached.add(piece);
  }
  if (settings.extent == model::Extent::kWhole) reached.add_all();
  return reached;
}

}  // namespace

SeparationStep separation_step(const scene::Scene& scene, const std::vector<OverlappingPair>& overlapping,
                               const std::vector<Vec>& home, const SeparationStepSettings& settings,
                               const scene::Run& run) {
  const auto near = pairs_within(scene.pieces, std::llround(settings.reach) + scene.pieces.widest_spacing());
  model::ActiveSet reached = moving(scene, overlapping, home, settings);
  SeparationStep step;
  for (;;) {
    run.observer.on_stage(scene::Stage::kRows);
    SeparationProgram program{scene, reached, settings};
    program.add_length();
    program.add_pairs(overlapping, near, run.stop);
    if (run.stopped()) {
      step.status = lp::LpStatus::kStopped;
      return step;
    }
    program.add_displacement_penalty(home);
    run.observer.on_stage(scene::Stage::kSolve);
    run.observer.on_program(program.program());
    const lp::LpSolution solution = program.solved(run);
    ++step.programs;
    step.status = solution.status;
    if (solution.status != lp::LpStatus::kOptimal) return step;
    const auto missed = program.missed(solution);
    if (missed.empty()) {
      program.take(solution, step);
      return step;
    }
    reached.grow(missed, near);
  }
}

}  // namespace selvage::motion::separation
