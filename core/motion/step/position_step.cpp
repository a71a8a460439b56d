#include "core/motion/step/position_step.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>

#include <boost/container/flat_set.hpp>

#include "core/marker/validity.h"
#include "core/model/snap.h"
#include "core/motion/step/obstacles.h"

namespace selvage::motion::step {
namespace {

constexpr int kAttempts = 24;            // programs in one round, as rows enter when they are broken
constexpr std::size_t kSmall = 64;       // pieces: the one program of so few is quicker than those of a growing set
constexpr double kLeastGain = 1e-5;      // of the goal, in column units: less is not worth proving
constexpr double kBroken = 1e-2;         // lattice units: by less no row is broken
constexpr double kPairAhead = 8;         // a pair's reach, as a multiple of what it moved in the last round
constexpr double kLeastPairReach = 0.2;  // as a part of the reach of all
constexpr std::size_t kBlock = 64;       // near pairs whose rows one hand finds in a row
constexpr std::size_t kCancelCheckInterval = 512;  // near pairs between two looks at whether to stop
constexpr double kSpare = 1e-2;  // column units the length may grow by in a program, for rows' margins

// The growing model of one round.
class Attempt {
 public:
  Attempt(const scene::Scene& scene, const Goal& goal, const StepSettings& settings, const scene::Run& run)
      : scene_{scene},
        goal_{goal},
        settings_{settings},
        run_{run},
        obstacles_{scene, settings.simplification},
        trust_{settings.trust * static_cast<double>(scene.marker.strip.width)},
        reached_{scene.ties},
        within_trust_{pairs_within(scene.pieces, std::llround(trust_) + scene.pieces.widest_spacing())} {
    if (held() && goal.displacement_penalty > 0 && !whole() && many_move()) {
      for (std::size_t i = 0; i < goal.force.size(); ++i) {
        if (goal.force[i].x != 0 || goal.force[i].y != 0) reached_.add(i);
      }
    } else {
      reached_.add_all();
    }
    know_near();
    model_near();
  }

  PositionStep run() {
    PositionStep step;
    lp::solver::LpLimits limits;
    if (!held()) limits.tolerance = settings_.tolerance;
    while (step.programs < kAttempts) {
      if (run_.stopped()) {
        step.end = StepEnd::kStopped;
        return step;
      }
      run_.observer.on_stage(scene::Stage::kSolve);
      run_.observer.on_program(model_->program());
      const lp::LpSolution solution = solve(model_->program(), settings_.solver, limits, run_.stop);
      ++step.programs;
      if (solution.status == lp::LpStatus::kInfeasible && tight_ == model::TightRows::kRestore) {
        if (reach_neighbours()) continue;
        tight_ = model::TightRows::kKeep;  // no room for the margins anywhere: a layout without slack
        model_near();
        continue;
      }
      if (solution.status != lp::LpStatus::kOptimal) {
        step.end = solution.status == lp::LpStatus::kStopped ? StepEnd::kStopped : StepEnd::kSolverFailed;
        return step;
      }
      run_.observer.on_stage(scene::Stage::kVerify);
      auto moves = model_->displacements(solution.x);
      step.end = StepEnd::kNoGain;
      const bool gains = -solution.objective >= kLeastGain;
      bool again = false;
      if (gains) {
        const double length_change = model_->length_change(solution.x);
        const Broken broken = broken_by(moves, length_change);
        if (!held() && -solution.objective < model::ModelUnit::of_width(settings_.worth)) {
          shorten(moves, part_within(broken, moves, length_change));
        } else {
          again = add(broken);
        }
      }
      if (reach_pressed(solution) || again) continue;
      if (!gains) return step;
      const auto conflict = try_moves(moves, step);
      if (conflict.empty()) return step;
      if (!add_colliding(conflict)) tie(conflict);
    }
    return step;
  }

 private:
  // Looks up the sums of pairs that have come to matter, unless asked to stop: where pieces were turned they are new,
  // and many in long markers.  Returns how many were known before.
  std::size_t know_near() {
    run_.observer.on_stage(scene::Stage::kSums);
    const std::size_t known = near_.size();
    for (const marker::PiecePair& pair : within_trust_) {
      if (!reached_.holds_any(pair) || reached_.ties().joined(pair.first, pair.second)) continue;
      if (!modelled_.contains(pair)) near_.push_back(pair);
    }
    modelled_.insert(near_.begin() + static_cast<std::ptrdiff_t>(known), near_.end());
    for (std::size_t done = known; done < near_.size(); done += kCancelCheckInterval) {
      if (run_.stopped()) {
        near_.resize(done);
        break;
      }
      auto obstacles = obstacles_.of(
          std::span{near_}.subspan(done, std::min(kCancelCheckInterval, near_.size() - done)), *run_.executor);
      std::move(obstacles.begin(), obstacles.end(), std::back_inserter(of_near_));
    }
    return known;
  }
  void model_near() {
    run_.observer.on_stage(scene::Stage::kRows);
    rows_.clear();
    modelled_ = {near_.begin(), near_.end()};
    append_near_rows(0);
    if (whole()) {
      append_all_others();
    } else if (!held()) {
      limit_drifting();
    }
    build();
  }
  // Gravity takes a piece that nothing near holds on its left beyond every limit: it is limited from the first.
  void limit_drifting() {
    std::vector<char> held_on_left(scene_.pieces.size());
    for (const model::PairRow& row : rows_) {
      if (row.nx > 0) held_on_left[row.pair.second] = 1;
      if (row.nx < 0) held_on_left[row.pair.first] = 1;
    }
    for (const marker::PiecePair& pair : near_) {
      char& first = held_on_left[pair.first];
      char& second = held_on_left[pair.second];
      if (first == second) continue;
      rows_.push_back({pair, first == 0 ? -1.0 : 1.0, 0, -2 * trust_});
      first = second = 1;
    }
  }
  void append_near_rows(std::size_t from) {
    const auto rows = gathered<model::PairRow>(
        *run_.executor, near_.size() - from, kBlock, [&](std::size_t k, std::vector<model::PairRow>& out) {
          append_rows(near_[from + k], of_near_[from + k], reach(near_[from + k]), out);
        });
    rows_.insert(rows_.end(), rows.begin(), rows.end());
  }
  // What would have entered only when a solution broke it.
  void append_all_others() {
    if (held()) {
      for (const marker::PiecePair& pair : near_) append_limits(pair);
    }
    std::vector<marker::PiecePair> all;
    for (std::uint32_t p = 0; p < scene_.pieces.size(); ++p) {
      for (std::uint32_t q = p + 1; q < scene_.pieces.size(); ++q) all.push_back({p, q});
    }
    append_far(all);
  }

  // Models what may move from now on.
  void model_reached() {
    const std::size_t known = know_near();
    run_.observer.on_stage(scene::Stage::kRows);
    append_near_rows(known);
    build();
  }
  // Programs may be too small: what they press upon moves too.  False when nothing is missed.
  bool reach_pressed(const lp::LpSolution& solution) {
    if (reached_.complete()) return false;
    model::Pressure pressure{scene_.pieces.size()};
    for (const auto& [row, k] : row_of_) pressure.add(rows_[k], solution.dual[static_cast<std::size_t>(row)]);
    const Box room = scene_.marker.strip.room(scene_.pieces.length());
    const auto missed = reached_.missed(scene_.pieces, pressure.load(), goal_.displacement_penalty, room);
    if (missed.empty()) return false;
    reached_.grow(missed, within_trust_);
    model_reached();
    return true;
  }
  // There is no room for what moves as long as its neighbours stay.  False when none of them could move.
  bool reach_neighbours() {
    if (reached_.complete()) return false;
    std::vector<std::uint32_t> around;
    for (const auto& [p, q] : near_) {
      if (reached_.may_hold(p)) around.push_back(p);
      if (reached_.may_hold(q)) around.push_back(q);
    }
    if (around.empty()) return false;
    reached_.grow(around, within_trust_);
    model_reached();
    return true;
  }

  void append_rows(marker::PiecePair pair, const minkowski::Obstacle& obstacle, double reach,
                   std::vector<model::PairRow>& rows) const {
    const Vec r = scene_.relative_position(pair);
    const Coord spacing = scene_.pieces.spacing(pair);
    const RealVec& p_force = goal_.force[pair.first];
    const RealVec& q_force = goal_.force[pair.second];
    const model::RegionSettings region{settings_.region,
                                       1.5 * reach + static_cast<double>(spacing),
                                       spacing,
                                       {q_force.x - p_force.x, q_force.y - p_force.y}};
    model::RowSettings row{model::ModelUnit{scene_.marker.strip}, tight_};
    if (!whole()) row.motion = reach;
    append_pair_rows(pair, {obstacle, r, r, spacing}, region, row, rows);
  }
  [[nodiscard]] bool held() const { return goal_.shorten == 0; }
  [[nodiscard]] bool many_move() const {
    std::size_t free = 0;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) free += scene_.fixed(i) ? 0 : 1;
    return free > kSmall;
  }
  // How far two near pieces are thought to move against each other, on an axis: rows farther away are left out.
  [[nodiscard]] double reach() const { return whole() && !held() ? static_cast<double>(kLatticeLimit) : 2 * trust_; }
  // The same of one pair: one that hardly moved in the last round hardly moves in this.
  [[nodiscard]] double reach(marker::PiecePair pair) const {
    if (held() || whole() || settings_.last_moves.empty()) return reach();
    const Vec by = settings_.last_moves[pair.second] - settings_.last_moves[pair.first];
    const auto moved = static_cast<double>(std::max(std::abs(by.x), std::abs(by.y)));
    return std::clamp(kPairAhead * moved, kLeastPairReach * reach(), reach());
  }
  [[nodiscard]] bool whole() const { return settings_.extent == model::Extent::kWhole; }
  [[nodiscard]] double unit() const { return model::ModelUnit{scene_.marker.strip}.lattice_units(); }

  void build() {
    const Coord length = scene_.pieces.length();
    // With the length held, a bound on every piece: no column for the length, no rows.
    const Strip& strip = scene_.marker.strip;
    model_.emplace(scene_.pieces, held() ? strip.ending(length) : strip, reached_.with_others_fixed());
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) model_->add_cost(i, -goal_.force[i].x, -goal_.force[i].y);
    if (!held()) {
      model_->add_length(goal_.shorten, static_cast<double>(length), kSpare * unit());
      for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
        if (static_cast<double>(length) - right_of(i) <= 2 * trust_ || whole()) model_->add_right_wall(i);
      }
    }
    if (goal_.halt) add_halt(*goal_.halt);
    if (goal_.displacement_penalty > 0) model_->add_displacement_penalty(goal_.displacement_penalty);
    row_of_.clear();
    for (std::size_t k = 0; k < rows_.size(); ++k) add_to_model(k);
  }
  void add_to_model(std::size_t k) {
    if (const auto row = model_->add(rows_[k])) row_of_.emplace_back(*row, k);
  }

  void add_halt(const Halt& halt) {
    const auto limit = [&](std::optional<int> column, double at) {
      if (!column) return;
      double& low = model_->program().lower[static_cast<std::size_t>(*column)];
      double& high = model_->program().upper[static_cast<std::size_t>(*column)];
      if (low > 0 || high < 0) return;  // it has to come back into the strip first
      low = std::max(low, std::min(0.0, at / unit()));
      high = std::min(high, std::max(0.0, at / unit()));
    };
    limit(model_->x_column(halt.piece), halt.at.x);
    limit(model_->y_column(halt.piece), halt.at.y);
  }

  // With the length held, forces are right about where pieces are: no near pair goes beyond the reach.
  void append_limits(marker::PiecePair pair) {
    for (const auto& [nx, ny] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
      rows_.push_back({pair, static_cast<double>(nx), static_cast<double>(ny), -reach()});
    }
  }
  // Rows that were left out and that moves break: of near pairs that moved beyond the reach, and of pieces beyond the
  // new end.
  struct Broken {
    std::vector<model::PairRow> rows;
    std::vector<std::size_t> right_walls;
  };
  [[nodiscard]] Broken broken_by(const std::vector<RealVec>& moves, double length_change) const {
    Broken broken;
    for (std::size_t k = 0; k < near_.size(); ++k) {
      const RealVec by = apart(near_[k], moves);
      const double far = std::max(std::abs(by.x), std::abs(by.y));
      if (far <= reach(near_[k]) * (1 + 1e-6)) continue;
      if (held()) {
        append_broken_limits(near_[k], by, broken.rows);
      } else {
        append_broken(near_[k], of_near_[k], by, far, broken.rows);
      }
    }
    if (held()) return broken;
    const double end = static_cast<double>(scene_.pieces.length()) + length_change;
    for (std::size_t i = 0; i < moves.size(); ++i) {
      if (!model_->has_right_wall(i) && right_of(i) + moves[i].x > end) broken.right_walls.push_back(i);
    }
    return broken;
  }
  void append_broken_limits(marker::PiecePair pair, RealVec by, std::vector<model::PairRow>& rows) const {
    const auto limit_axis = [&](double way, double nx, double ny) {
      if (std::abs(way) > reach()) rows.push_back({pair, way > 0 ? -nx : nx, way > 0 ? -ny : ny, -reach()});
    };
    limit_axis(by.x, 1, 0);
    limit_axis(by.y, 0, 1);
  }
  // Of the rows of a pair up to `reach`.
  void append_broken(marker::PiecePair pair, const minkowski::Obstacle& obstacle, RealVec by, double reach,
                     std::vector<model::PairRow>& rows) const {
    std::vector<model::PairRow> all;
    append_rows(pair, obstacle, reach, all);
    std::copy_if(all.begin(), all.end(), std::back_inserter(rows),
                 [&](const model::PairRow& row) { return along(row, by) < row.bound - kBroken; });
  }
  // False when there is nothing to add.
  bool add(const Broken& broken) {
    for (const model::PairRow& row : broken.rows) {
      rows_.push_back(row);
      add_to_model(rows_.size() - 1);
    }
    for (const std::size_t i : broken.right_walls) model_->add_right_wall(i);
    return !broken.rows.empty() || !broken.right_walls.empty();
  }
  // How much of the moves the rows they break allow; all other rows allow any part, as they do all and nothing.
  [[nodiscard]] double part_within(const Broken& broken, const std::vector<RealVec>& moves,
                                   double length_change) const {
    double part = 1;
    for (const model::PairRow& row : broken.rows) part = std::min(part, row.bound / along(row, apart(row.pair, moves)));
    const auto length = static_cast<double>(scene_.pieces.length());
    for (const std::size_t i : broken.right_walls) {
      part = std::min(part, (length - right_of(i)) / (moves[i].x - length_change));
    }
    return std::max(0.0, part);
  }
  static RealVec apart(marker::PiecePair pair, const std::vector<RealVec>& moves) {
    const RealVec& p = moves[pair.first];
    const RealVec& q = moves[pair.second];
    return {q.x - p.x, q.y - p.y};
  }
  static double along(const model::PairRow& row, RealVec by) { return row.nx * by.x + row.ny * by.y; }
  static void shorten(std::vector<RealVec>& moves, double part) {
    for (RealVec& d : moves) d = {d.x * part, d.y * part};
  }
  [[nodiscard]] double right_of(std::size_t i) const { return static_cast<double>(scene_.pieces.box(i).high.x); }

  // Rounds and proves the moves; shortens them a little when rounding breaks something.  Returns what collides all the
  // same; moves that collide nowhere become the step's when they serve the goal.
  std::vector<marker::PiecePair> try_moves(const std::vector<RealVec>& moves, PositionStep& step) const {
    std::vector<marker::PiecePair> first_conflict;
    for (const double part : {1.0, 1 - 1e-6, 1 - 1e-3, 0.5}) {
      std::vector<RealVec> scaled = moves;
      shorten(scaled, part);
      marker::PlacedPieces moved = scene_.pieces;
      std::vector<Vec> positions = model::snapped(scaled);
      for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = positions[i] + scene_.pieces.at(i);
      moved.place(std::move(positions));
      auto conflict = conflicts(moved, *run_.executor);
      if (conflict.empty()) {
        if (moved.length() <= scene_.pieces.length() && inside(moved) && gain(moved) > 0) {
          step.end = StepEnd::kMoved;
          step.positions = moved.positions();
          step.farthest = farthest(scaled);
          step.gain = gain(moved) / static_cast<double>(scene_.marker.strip.width);
        }
        return {};
      }
      if (part == 1.0) first_conflict = std::move(conflict);
      const bool rounding_only = std::all_of(first_conflict.begin(), first_conflict.end(),
                                             [&](const marker::PiecePair& pair) { return modelled_.contains(pair); });
      if (!rounding_only) break;
    }
    return first_conflict;
  }
  // What the goal gains, after rounding; lattice units.
  [[nodiscard]] double gain(const marker::PlacedPieces& moved) const {
    double sum = goal_.shorten * static_cast<double>(scene_.pieces.length() - moved.length());
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const Vec by = moved.at(i) - scene_.pieces.at(i);
      sum += goal_.force[i].x * static_cast<double>(by.x) + goal_.force[i].y * static_cast<double>(by.y);
    }
    return sum;
  }
  [[nodiscard]] double farthest(const std::vector<RealVec>& moves) const {
    double most = 0;
    for (const marker::PiecePair& pair : near_) {
      const RealVec by = apart(pair, moves);
      most = std::max({most, std::abs(by.x), std::abs(by.y)});
    }
    return most / static_cast<double>(scene_.marker.strip.width);
  }
  [[nodiscard]] bool inside(const marker::PlacedPieces& moved) const {
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (protrusion_of(moved.box(i), scene_.marker.strip) > 0) return false;
    }
    return true;
  }

  // Models pairs that were not near and collide.  False when all are modelled already.
  bool add_colliding(const std::vector<marker::PiecePair>& conflict) {
    const std::size_t before = rows_.size();
    const bool any = append_far(conflict);
    for (std::size_t k = before; k < rows_.size(); ++k) add_to_model(k);
    return any;
  }
  // All rows of those of the pairs that are not modelled.  False when all are.
  bool append_far(const std::vector<marker::PiecePair>& pairs) {
    std::vector<marker::PiecePair> far;
    std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(far),
                 [&](const marker::PiecePair& pair) { return !modelled_.contains(pair); });
    for (const marker::PiecePair& pair : far)
      append_rows(pair, obstacles_.of(pair), static_cast<double>(kLatticeLimit), rows_);
    modelled_.insert(far.begin(), far.end());
    return !far.empty();
  }

  // Pieces that rounding keeps breaking apart move as one: what fits now still fits then.
  void tie(const std::vector<marker::PiecePair>& conflict) {
    for (const auto& [p, q] : conflict) reached_.join(p, q);
    model_reached();
  }

  const scene::Scene& scene_;
  const Goal& goal_;
  const StepSettings& settings_;
  const scene::Run& run_;
  Obstacles obstacles_;
  double trust_;
  model::ActiveSet reached_;
  std::vector<marker::PiecePair> within_trust_;
  std::vector<marker::PiecePair> near_;       // of these, those that can move against each other
  std::vector<minkowski::Obstacle> of_near_;  // and their obstacles
  model::TightRows tight_{model::TightRows::kRestore};
  std::vector<model::PairRow> rows_;
  std::vector<std::pair<int, std::size_t>> row_of_;  // of the program, and its place in rows_
  boost::container::flat_set<marker::PiecePair> modelled_;
  std::optional<model::PositionModel> model_;
};

}  // namespace

Goal leftward_goal(const scene::Scene& scene, double gravity) {
  const auto count = static_cast<double>(scene.pieces.size());
  return {std::vector<RealVec>(scene.pieces.size(), {-gravity / count, 0}), 1, 0};
}

PositionStep position_step(const scene::Scene& scene, const Goal& goal, const StepSettings& settings,
                           const scene::Run& run) {
  return Attempt{scene, goal, settings, run}.run();
}

}  // namespace selvage::motion::step
