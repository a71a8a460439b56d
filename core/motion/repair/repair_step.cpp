#include "core/motion/repair/repair_step.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "core/lp/solver/solve.h"
#include "core/model/active_set.h"
#include "core/model/position_model.h"
#include "core/model/snap.h"

namespace selvage::motion::repair {
namespace {

class RepairProgram {
 public:
  // Whether simplex is tried on programs that the interior point method cannot solve.  It takes long to find that a
  // program is infeasible, as most of these are.
  enum class Simplex { kNever, kAsLastResort };

  RepairProgram(const scene::Scene& scene, const std::vector<Conflict>& conflicts, double reach,
                const RepairTuning& tuning, const scene::Run& run)
      : scene_{scene},
        conflicts_{conflicts},
        reach_{reach},
        tuning_{tuning},
        run_{run},
        near_{pairs_within(scene.pieces, std::llround(reach) + scene.pieces.widest_spacing())},
        active_{with_match_sets(scene.ties, scene.pieces, scene.marker.strip)} {
    for (const Conflict& conflict : conflicts) {
      active_.add(conflict.pair.first);
      active_.add(conflict.pair.second);
    }
    for (std::size_t i = 0; i < scene.pieces.size(); ++i) {
      if (protrusion(scene, i) > 0) active_.add(i);
    }
    for (const marker::Shade& shade : scene.pieces.shades()) {
      if (scene.pieces.excess_of(shade) <= 0) continue;
      for (const std::uint32_t piece : shade.pieces) active_.add(piece);
    }
  }

  // The displacements of least cost with which the marker grows by at most `growth`; solved for the active pieces, and
  // again for more of them as long as rows press on others, or there is no room.  Where all of them have no room
  // either, pairs that lie closer than their rows' margins keep the room they have: a stack may fill the strip exactly.
  std::optional<std::vector<RealVec>> solve_within(double growth, Simplex simplex) {
    for (;;) {
      run_.observer.on_stage(scene::Stage::kRows);
      build(growth);
      run_.observer.on_stage(scene::Stage::kSolve);
      run_.observer.on_program(model_->program());
      const lp::LpSolution solution = solved(simplex);
      std::vector<std::uint32_t> wanted;
      if (solution.status == lp::LpStatus::kOptimal) {
        wanted = pressed_by(solution);
        if (wanted.empty()) return model_->displacements(solution.x);
      } else if (!run_.stopped()) {
        wanted = neighbours();
        if (wanted.empty() && tight_ == model::TightRows::kRestore) {
          tight_ = model::TightRows::kKeep;
          continue;
        }
      }
      if (wanted.empty()) return std::nullopt;
      active_.grow(std::move(wanted), near_);
    }
  }

 private:
  [[nodiscard]] lp::LpSolution solved(Simplex simplex) const {
    lp::solver::LpLimits limits;
    limits.falls_back = simplex == Simplex::kAsLastResort && tight_ == model::TightRows::kKeep;
    limits.reach = model_->reach();
    return solve(model_->program(), lp::solver::SolverChoice::kAutomatic, limits, run_.stop, *run_.executor);
  }

  void build(double growth) {
    model_.emplace(scene_.pieces, scene_.marker.strip, active_.with_others_fixed());
    model_->add_length(tuning_.length_cost, 0, growth);
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) model_->add_right_wall(i);
    rows_.clear();
    for (const model::PairRow& row : near_rows()) {
      if (const auto added = model_->add(row)) rows_.emplace_back(*added, row);
    }
    model_->add_displacement_penalty(tuning_.displacement_cost);
  }

  // The rows of all near pairs of which at least one piece is active.
  [[nodiscard]] std::vector<model::PairRow> near_rows() const {
    std::vector<marker::PiecePair> pairs;
    std::copy_if(near_.begin(), near_.end(), std::back_inserter(pairs),
                 [&](const marker::PiecePair& pair) { return active_.holds_any(pair); });
    const auto obstacles = scene_.obstacles(pairs, *run_.executor, run_.stop);
    std::vector<model::PairRow> rows;
    if (obstacles.size() < pairs.size()) return rows;  // cancelled: the solver stops at once
    auto conflict = conflicts_.begin();                // both lists are sorted by pair
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      while (conflict != conflicts_.end() && conflict->pair < pairs[k]) ++conflict;
      const bool in_conflict = conflict != conflicts_.end() && conflict->pair == pairs[k];
      const Vec r = scene_.relative_position(pairs[k]);
      const Coord spacing = scene_.pieces.spacing(pairs[k]);
      append_pair_rows(pairs[k], {obstacles[k], r, in_conflict ? conflict->target.about : r, spacing},
                       model::region_within(reach_, spacing), {model_->unit(), tight_}, rows);
    }
    return rows;
  }

  [[nodiscard]] std::vector<std::uint32_t> pressed_by(const lp::LpSolution& solution) const {
    model::Pressure pressure{scene_.pieces.size()};
    for (const auto& [row, pair_row] : rows_) pressure.add(pair_row, solution.dual[static_cast<std::size_t>(row)]);
    pressure.add_shades(*model_, solution.dual);
    const Strip& strip = scene_.marker.strip;
    return active_.missed(scene_.pieces, pressure.load(), tuning_.displacement_cost, strip,
                          strip.last().value_or(kLatticeLimit));
  }

  // The inactive neighbours of active pieces: moving them may make room.
  [[nodiscard]] std::vector<std::uint32_t> neighbours() const {
    std::vector<std::uint32_t> pieces;
    for (const auto& [p, q] : near_) {
      if (active_.holds(p) && active_.may_hold(q)) pieces.push_back(q);
      if (active_.holds(q) && active_.may_hold(p)) pieces.push_back(p);
    }
    return pieces;
  }

  const scene::Scene& scene_;
  const std::vector<Conflict>& conflicts_;
  double reach_;  // lattice units
  const RepairTuning& tuning_;
  const scene::Run& run_;
  std::vector<marker::PiecePair> near_;
  model::ActiveSet active_;
  model::TightRows tight_{model::TightRows::kRestore};
  std::optional<model::PositionModel> model_;
  std::vector<std::pair<int, model::PairRow>> rows_;  // of the program, and what they say
};

}  // namespace

bool repair_step(scene::Scene& scene, const std::vector<Conflict>& conflicts, double limit, const RepairTuning& tuning,
                 const scene::Run& run) {
  run.observer.on_stage(scene::Stage::kRows);
  const double reach = tuning.reach * limit;
  RepairProgram program{scene, conflicts, reach, tuning, run};
  using Simplex = RepairProgram::Simplex;
  const double spare = model::ModelUnit{scene.marker.strip}.to_lattice(tuning.spare_length);
  for (const auto& [growth, simplex] : {std::pair{spare, Simplex::kNever}, std::pair{reach, Simplex::kAsLastResort}}) {
    if (const auto displacements = program.solve_within(growth, simplex)) {
      scene.pieces.move_by(model::snapped(*displacements));
      return true;
    }
    if (run.stopped()) return false;
  }
  return false;
}

}  // namespace selvage::motion::repair
