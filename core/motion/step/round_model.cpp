#include "core/motion/step/round_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "core/lp/solver/solve_locally.h"
#include "core/model/snap.h"

namespace selvage::motion::step {
namespace {

bool is_large(const scene::Scene& scene, const StepSettings& settings) {
  std::size_t free = 0;
  for (std::size_t i = 0; i < scene.pieces.size(); ++i) free += scene.fixed(i) ? 0 : 1;
  return free > settings.tuning.small_marker;
}

// All pieces, or, where staying costs nothing and moving does, those that a force acts on.
model::ActiveSet initially_active(const scene::Scene& scene, const Goal& goal, const StepSettings& settings) {
  model::ActiveSet active{with_match_sets(scene.ties, scene.pieces, scene.marker.strip),
                          settings.tuning.active_set_growth};
  const bool staying_is_free = goal.fixes_length() && goal.displacement_penalty > 0;
  if (!staying_is_free || settings.extent == model::Extent::kWhole || !is_large(scene, settings)) {
    active.add_all();
    return active;
  }
  for (std::size_t i = 0; i < goal.force.size(); ++i) {
    if (goal.force[i].x != 0 || goal.force[i].y != 0) active.add(i);
  }
  return active;
}

std::vector<marker::PiecePair> every_pair(std::size_t pieces) {
  std::vector<marker::PiecePair> all;
  for (std::uint32_t p = 0; p < pieces; ++p) {
    for (std::uint32_t q = p + 1; q < pieces; ++q) all.push_back({p, q});
  }
  return all;
}

void add_halt(model::PositionModel& model, const Halt& halt) {
  const auto limit = [&](std::optional<int> column, double at) {
    if (!column) return;
    double& low = model.program().lower[static_cast<std::size_t>(*column)];
    double& high = model.program().upper[static_cast<std::size_t>(*column)];
    if (low > 0 || high < 0) return;  // the piece has to come back into the strip first
    low = std::max(low, std::min(0.0, model.unit().to_columns(at)));
    high = std::min(high, std::max(0.0, model.unit().to_columns(at)));
  };
  limit(model.x_column(halt.piece), halt.at.x);
  limit(model.y_column(halt.piece), halt.at.y);
}

}  // namespace

RoundModel::RoundModel(const scene::Scene& scene, const Goal& goal, const StepSettings& settings, const scene::Run& run)
    : scene_{scene},
      goal_{goal},
      settings_{settings},
      run_{run},
      active_{initially_active(scene, goal, settings)},
      near_{scene, goal, settings},
      length_{length_mode(scene, goal, settings, near_)} {
  extend_near();
  restart();
  first_rows_ = rows_.size();
}

lp::LpSolution RoundModel::solve() {
  if (local_) return *std::exchange(local_, {});
  ++programs_;
  local_solutions_ = 0;
  run_.observer.on_stage(scene::Stage::kSolve);
  run_.observer.on_program(model_->program());
  lp::solver::LpLimits limits;
  limits.reach = model_->reach();
  if (!goal_.fixes_length()) {
    limits.tolerance = settings_.tolerance;
    // Most programs that fail are infeasible because of margins (make_feasible), and simplex takes long to find that.
    limits.falls_back = tight_ == model::TightRows::kKeep;
  }
  return lp::solver::solve(model_->program(), settings_.solver, limits, run_.stop, *run_.executor);
}

void RoundModel::solve_locally(const lp::LpSolution& solution) {
  const StepTuning& tuning = settings_.tuning;
  if (goal_.fixes_length() || scene_.pieces.size() < tuning.large_marker || local_solutions_ == tuning.local_solutions)
    return;
  ++local_solutions_;
  run_.observer.on_stage(scene::Stage::kSolve);
  const lp::LinearProgram& program = model_->program();
  auto x = lp::solver::solved_locally(program, solution.x, run_.stop, *run_.executor);
  if (!x) return;
  const double objective = std::inner_product(x->begin(), x->end(), program.cost.begin(), 0.0);
  if (-objective < tuning.local_gain * -solution.objective) return;
  local_ = lp::LpSolution{solution.status, *std::move(x), solution.dual, objective, solution.iterations};
}

Moves RoundModel::moves(const lp::LpSolution& solution) const {
  return {model_->displacements(solution.x), model_->length_change(solution.x)};
}

bool RoundModel::make_feasible() {
  if (tight_ == model::TightRows::kKeep) return false;
  std::vector<std::uint32_t> neighbours;
  for (const auto& [p, q] : near_.pairs()) {
    if (active_.may_hold(p)) neighbours.push_back(p);
    if (active_.may_hold(q)) neighbours.push_back(q);
  }
  if (!neighbours.empty()) {
    grow(std::move(neighbours));
    return true;
  }
  tight_ = model::TightRows::kKeep;
  restart();
  return true;
}

bool RoundModel::add_broken_rows(Moves& moves, double gain) {
  const BrokenRows broken = length_->broken_by(moves, *model_, tight_);
  if (broken.empty()) return false;
  if (!goal_.fixes_length() && gain < model::ModelUnit::of_width(settings_.worth)) {
    shorten_to(broken, moves);
    return false;
  }
  for (const model::PairRow& row : broken.rows) {
    rows_.push_back(row);
    add_row(rows_.size() - 1);
  }
  for (const std::size_t i : broken.right_walls) model_->add_right_wall(i);
  return true;
}

void RoundModel::shorten(Moves& moves) const {
  shorten_to(length_->broken_by(moves, *model_, tight_), moves);
}

void RoundModel::shorten_to(const BrokenRows& broken, Moves& moves) const {
  if (broken.empty()) return;
  moves.displacements = scaled(moves.displacements, feasible_fraction(scene_.pieces, broken, moves));
}

bool RoundModel::add_pressed_pieces(const lp::LpSolution& solution) {
  if (active_.complete()) return false;
  model::Pressure pressure{scene_.pieces.size()};
  for (const auto& [row, k] : row_of_) {
    const auto r = static_cast<std::size_t>(row);
    if (r < solution.dual.size()) pressure.add(rows_[k], solution.dual[r]);  // later rows were added since
  }
  pressure.add_shades(*model_, solution.dual);
  auto pressed = active_.missed(scene_.pieces, pressure.load(), goal_.displacement_penalty, scene_.marker.strip,
                                scene_.pieces.length());
  if (pressed.empty()) return false;
  grow(std::move(pressed));
  return true;
}

std::vector<model::PairRow> RoundModel::pressed_rows(const lp::LpSolution& solution) const {
  std::vector<model::PairRow> pressed;
  for (const auto& [row, k] : row_of_) {
    const auto r = static_cast<std::size_t>(row);
    if (r < solution.dual.size() && solution.dual[r] > settings_.tuning.pressed * goal_.shorten)
      pressed.push_back(rows_[k]);
  }
  return pressed;
}

bool RoundModel::add_pairs(const std::vector<marker::PiecePair>& pairs) {
  std::vector<marker::PiecePair> fresh;
  std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(fresh),
               [&](const marker::PiecePair& pair) { return !modelled_.contains(pair); });
  const std::size_t before = rows_.size();
  for (const marker::PiecePair& pair : fresh) near_.append_all_rows(pair, tight_, rows_);
  for (std::size_t k = before; k < rows_.size(); ++k) add_row(k);
  modelled_.insert(fresh.begin(), fresh.end());
  return !fresh.empty();
}

std::vector<marker::PiecePair> RoundModel::ahead_of(const Moves& moves,
                                                    const std::vector<marker::PiecePair>& colliding) const {
  std::vector<char> collides(scene_.pieces.size());
  for (const auto& [p, q] : colliding) collides[p] = collides[q] = 1;
  marker::PlacedPieces moved = scene_.pieces;
  moved.move_by(model::snapped(moves.displacements));
  const double near = settings_.tuning.foresight * settings_.trust * static_cast<double>(scene_.marker.strip.width);
  std::vector<marker::PiecePair> pairs = pairs_within(moved, std::llround(near) + moved.widest_spacing());
  std::erase_if(pairs,
                [&](const marker::PiecePair& pair) { return collides[pair.first] == 0 && collides[pair.second] == 0; });
  return pairs;
}

bool RoundModel::limit_flights(const Moves& moves) {
  if (scene_.pieces.size() < settings_.tuning.large_marker) return false;
  const auto limits = length_->limits_of_flights(moves, settings_.tuning.flight * near_.motion());
  for (const model::PairRow& row : limits) {
    rows_.push_back(row);
    add_row(rows_.size() - 1);
  }
  return !limits.empty();
}

void RoundModel::tie(const std::vector<marker::PiecePair>& pairs) {
  for (const auto& [p, q] : pairs) active_.join(p, q);
  grow({});
}

bool RoundModel::has_outgrown() const {
  const StepTuning& tuning = settings_.tuning;
  const auto most = tuning.most_growth * static_cast<double>(first_rows_) + static_cast<double>(tuning.spare_rows);
  return !goal_.fixes_length() && static_cast<double>(rows_.size()) > most;
}

std::size_t RoundModel::extend_near() {
  run_.observer.on_stage(scene::Stage::kSums);
  const std::size_t known = near_.extend(active_, modelled_, run_);
  modelled_.insert(near_.pairs().begin() + static_cast<std::ptrdiff_t>(known), near_.pairs().end());
  return known;
}

void RoundModel::restart() {
  run_.observer.on_stage(scene::Stage::kRows);
  modelled_ = PairSet(near_.pairs().begin(), near_.pairs().end());
  rows_ = near_.rows_from(0, tight_, *run_.executor);
  length_->append_first_rows(rows_);
  build();
  if (settings_.extent == model::Extent::kWhole) add_pairs(every_pair(scene_.pieces.size()));
}

void RoundModel::grow(std::vector<std::uint32_t> pieces) {
  active_.grow(std::move(pieces), near_.within_trust());
  const std::size_t known = extend_near();
  run_.observer.on_stage(scene::Stage::kRows);
  const auto rows = near_.rows_from(known, tight_, *run_.executor);
  rows_.insert(rows_.end(), rows.begin(), rows.end());
  build();
}

void RoundModel::build() {
  model_.emplace(length_->model(active_.with_others_fixed()));
  for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
    model_->add_cost(i, -goal_.force[i].x, -goal_.force[i].y);
  }
  if (goal_.halt) add_halt(*model_, *goal_.halt);
  if (goal_.displacement_penalty > 0) model_->add_displacement_penalty(goal_.displacement_penalty);
  row_of_.clear();
  for (std::size_t k = 0; k < rows_.size(); ++k) add_row(k);
}

void RoundModel::add_row(std::size_t k) {
  if (const auto row = model_->add(rows_[k])) row_of_.emplace_back(*row, k);
}

}  // namespace selvage::motion::step
