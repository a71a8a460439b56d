#include "core/motion/parting_step.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/model/position_model.h"
#include "core/model/snap.h"

namespace selvage {
namespace {

class PartingProgram {
 public:
  PartingProgram(const Scene& scene, const PartingSettings& settings)
      : scene_{scene},
        settings_{settings},
        length_{scene.pieces.length()},
        model_{scene.pieces, scene.marker.strip.ending({}), scene.ties} {}

  void add_length() {
    const LengthAllowance& allowance = settings_.length;
    const Coord shorten = std::max(Coord{0}, length_ - allowance.free);
    model_.add_length(allowance.price, static_cast<double>(shorten), kInfinity);
    const int length_column = model_.program().columns() - 1;
    const int excess = model_.program().add_column(allowance.excess_price, 0, kInfinity);
    // excess >= length - allowed
    const double room = static_cast<double>(allowance.allowed - length_) / model_.unit();
    model_.program().add_row(std::array<LinearProgram::Entry, 2>{{{excess, 1}, {length_column, -1}}}, -room);
    const double watched = static_cast<double>(length_ - shorten) - 2 * settings_.reach;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (static_cast<double>(scene_.pieces.box(i).high.x) >= watched) model_.add_right_wall(i);
    }
  }

  void add_pairs(const std::vector<PartingPair>& parting) {
    const Coord spacing = scene_.pieces.widest_spacing();
    auto parted = parting.begin();
    for (const PiecePair& pair : pairs_within(scene_.pieces, std::llround(settings_.reach) + spacing)) {
      const bool parts = parted != parting.end() && parted->pair == pair;
      if (parts) {
        add_pair(pair, parted->target.about, parted->price);
        ++parted;
      } else {
        add_pair(pair, scene_.relative_position(pair), settings_.price);
      }
    }
  }

  void add_stillness(const std::vector<Vec>& home) { model_.add_stillness(1, home); }

  [[nodiscard]] PartingStep solved(const std::stop_token& stop) const {
    const LpSolution solution = solve(model_.program(), settings_.solver, {}, stop);
    PartingStep step;
    step.status = solution.status;
    if (solution.status != LpStatus::kOptimal) return step;
    step.positions = snapped(model_.displacements(solution.x));
    for (std::size_t i = 0; i < step.positions.size(); ++i) step.positions[i] = step.positions[i] + scene_.pieces.at(i);
    step.pressure.assign(scene_.pieces.size(), 0);
    for (const auto& [row, pair] : row_of_pair_) {
      step.pressure[pair.first] += solution.dual[row];
      step.pressure[pair.second] += solution.dual[row];
    }
    return step;
  }

  [[nodiscard]] const LinearProgram& program() const { return model_.program(); }

 private:
  // The rows of one pair; all that its present position breaks may stay broken by the same amount.
  void add_pair(PiecePair pair, Vec about, double price) {
    if (scene_.ties.joined(pair.first, pair.second)) return;
    const Coord spacing = scene_.pieces.spacing(pair);
    const Vec r = scene_.relative_position(pair);
    const RegionSettings region{RegionRule::kGreedy, settings_.reach + static_cast<double>(spacing), spacing};
    rows_.clear();
    for (const HalfPlane& side : free_region(scene_.obstacle(pair), about, region)) {
      rows_.push_back(row_of(pair, side, r, spacing, model_.unit(), TightRows::kKeep));
    }
    std::optional<int> give;
    if (std::any_of(rows_.begin(), rows_.end(), [](const PairRow& row) { return row.bound > 0; })) {
      give = model_.program().add_column(price, 0, kInfinity);
    }
    for (const PairRow& row : rows_) {
      row_of_pair_.emplace_back(static_cast<std::size_t>(model_.program().rows()), pair);
      model_.add(row, row.bound > 0 ? give : std::nullopt);
    }
  }

  const Scene& scene_;
  const PartingSettings& settings_;
  Coord length_;
  PositionModel model_;
  std::vector<PairRow> rows_;
  std::vector<std::pair<std::size_t, PiecePair>> row_of_pair_;
};

}  // namespace

PartingStep parting_step(const Scene& scene, const std::vector<PartingPair>& parting, const std::vector<Vec>& home,
                         const PartingSettings& settings, const std::stop_token& stop, const Observer& observer) {
  observer.on_stage(Stage::kRows);
  PartingProgram program{scene, settings};
  program.add_length();
  program.add_pairs(parting);
  program.add_stillness(home);
  observer.on_stage(Stage::kSolve);
  observer.on_program(program.program());
  return program.solved(stop);
}

}  // namespace selvage
