#include "core/motion/tilting/tilt_step.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/marker/clearance.h"
#include "core/minkowski/inner_fit.h"
#include "core/model/snap.h"
#include "core/motion/piece/tilted_piece.h"
#include "core/motion/repair/separation_target.h"

namespace selvage::motion::tilting {
namespace {

constexpr double kRadian = 180 / std::numbers::pi;  // degrees
constexpr std::size_t kBlock = 16;                  // near pairs whose rows one task finds
constexpr std::size_t kPairsAtOnce = 512;           // near pairs whose sums are found together

class Program {
 public:
  Program(const scene::Scene& scene, const TiltStepSettings& settings)
      : scene_{scene},
        tuning_{settings.tuning},
        farthest_{settings.trust * static_cast<double>(scene.marker.strip.width)},
        turn_{settings.turn.degrees / kRadian},
        turns_{ranges(scene, turn_)},
        model_{scene.pieces, scene.marker.strip, scene.ties, turns_, farthest_} {}

  void add_goal(const step::Goal& goal, std::span<const double> torque) {
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      model_.positions().add_cost(i, -goal.force[i].x, -goal.force[i].y);
      const auto turn = model_.turn_column(i);
      if (turn && !torque.empty()) model_.positions().program().cost[static_cast<std::size_t>(*turn)] = -torque[i];
    }
    if (goal.shorten == 0) {
      model_.fix_length();
    } else {
      const double shorten = std::min(static_cast<double>(scene_.pieces.length()), 2 * farthest_);
      model_.add_length(goal.shorten, shorten, model_.positions().unit().to_lattice(tuning_.length_spare));
    }
  }

  // False when cancelled: turned pieces need new sums, which takes long in long markers.
  bool add_pairs(const scene::Run& run) {
    run.observer.on_stage(scene::Stage::kSums);
    const double most_swing = turn_ * widest_radius();
    const double reach = 2 * (farthest_ + most_swing);
    const std::vector<marker::PiecePair> overlapping = conflicts(scene_.pieces, *run.executor);
    auto near = pairs_within(scene_.pieces, std::llround(reach) + scene_.pieces.widest_spacing());
    std::erase_if(near, [&](const marker::PiecePair& pair) { return scene_.ties.joined(pair.first, pair.second); });
    for (std::size_t done = 0; done < near.size(); done += kPairsAtOnce) {
      const std::size_t count = std::min(kPairsAtOnce, near.size() - done);
      if (!add_rows(std::span{near}.subspan(done, count), overlapping, reach, run)) return false;
    }
    return true;
  }

  // False when cancelled.
  bool add_rows(std::span<const marker::PiecePair> near, const std::vector<marker::PiecePair>& overlapping,
                double reach, const scene::Run& run) {
    const auto obstacles = scene_.obstacles(near, *run.executor, run.stop);
    if (obstacles.size() < near.size()) return false;
    using Rows = std::vector<model::tilting::TiltRow>;
    const auto found = gathered<Rows>(*run.executor, near.size(), kBlock, [&](std::size_t k, std::vector<Rows>& out) {
      const bool overlaps = std::binary_search(overlapping.begin(), overlapping.end(), near[k]);
      out.push_back(rows_of(near[k], obstacles[k], overlaps, reach));
    });
    for (const Rows& rows : found) {
      std::optional<int> give;
      if (std::any_of(rows.begin(), rows.end(),
                      [](const model::tilting::TiltRow& made) { return made.row.bound > 0; })) {
        give = model_.positions().program().add_column(tuning_.overlap_price, 0, lp::kInfinity);
      }
      for (const model::tilting::TiltRow& made : rows) model_.add(made, made.row.bound > 0 ? give : std::nullopt);
    }
    return true;
  }

  [[nodiscard]] std::vector<model::tilting::TiltRow> rows_of(marker::PiecePair pair,
                                                             const minkowski::Obstacle& obstacle, bool overlaps,
                                                             double reach) const {
    const Coord spacing = scene_.pieces.spacing(pair);
    repair::SeparationTarget target{0, scene_.relative_position(pair)};
    if (overlaps) target = separation_target(scene_, pair, repair::TargetRule::kNearest);
    const auto sides = region_of({obstacle, scene_.relative_position(pair), target.about, spacing},
                                 model::region_within(1.5 * reach, spacing));
    const auto allowance = static_cast<double>(std::max(-spacing, Coord{0}));
    const model::tilting::TiltRowSettings row{turn_, 1.5 * reach, (overlaps ? 2 * target.depth : 0) + allowance,
                                              spacing + clearance(), model_.positions().unit()};
    const auto [p, q] = pair;
    return tilt_rows(pair, scene_.pieces.facing(p, q), scene_.pieces.facing(q, p), sides, row);
  }

  [[nodiscard]] TiltStep solved(lp::solver::SolverChoice solver, const scene::Run& run) const {
    lp::solver::LpLimits limits;
    limits.reach = model_.positions().reach();
    const lp::LpSolution solution = solve(model_.program(), solver, limits, run.stop, *run.executor);
    TiltStep step;
    step.status = solution.status;
    if (solution.status != lp::LpStatus::kOptimal) return step;
    step.pieces = moved(solution.x);
    return step;
  }

  [[nodiscard]] const lp::LinearProgram& program() const { return model_.program(); }

 private:
  static std::vector<model::tilting::TurnRange> ranges(const scene::Scene& scene, double turn) {
    std::vector<model::tilting::TurnRange> turns(scene.pieces.size());
    for (std::uint32_t i = 0; i < turns.size(); ++i) {
      const piece::TiltRange range = piece::tilt_range(scene.marker, PieceId{i});
      const double now = scene.marker.pieces[i].orientation.tilt.degrees;
      turns[i].least = std::clamp((range.least.degrees - now) / kRadian, -turn, 0.0);
      turns[i].most = std::clamp((range.most.degrees - now) / kRadian, 0.0, turn);
    }
    return turns;
  }
  [[nodiscard]] Coord clearance() const {
    return tuning_.least_clearance + std::llround(tuning_.clearance * static_cast<double>(scene_.marker.strip.width));
  }
  [[nodiscard]] double widest_radius() const {
    double most = 0;
    for (std::size_t i = 0; i < turns_.size(); ++i) {
      if (!turns_[i].empty()) most = std::max(most, model::tilting::radius_of(scene_.pieces[i]));
    }
    return most;
  }

  [[nodiscard]] std::vector<Piece> moved(std::span<const double> x) const {
    std::vector<Piece> pieces = scene_.marker.pieces;
    std::vector<RealVec> moves = model_.positions().displacements(x);
    const std::vector<double> turns = model_.turns(x);
    for (std::uint32_t i = 0; i < pieces.size(); ++i) {
      pieces[i].at = scene_.pieces.at(i);
      if (std::abs(turns[i]) * model::tilting::radius_of(scene_.pieces[i]) < tuning_.least_arc) continue;
      Piece turned_piece = pieces[i];
      double& tilt = turned_piece.orientation.tilt.degrees;
      const double before = tilt;
      const piece::TiltRange range = piece::tilt_range(scene_.marker, PieceId{i});
      tilt = std::clamp(tilt + turns[i] * kRadian, range.least.degrees, range.most.degrees);
      if (!piece::is_cuttable(scene_.marker, turned_piece)) continue;
      const RealVec held = piece::held_pivot(scene_.pieces[i], Angle::of_degrees(tilt - before));
      moves[i] = {moves[i].x + held.x, moves[i].y + held.y};
      pieces[i] = turned_piece;
    }
    const std::vector<Vec> by = model::snapped(moves);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      pieces[i].at = pieces[i].at + by[i];
      if (!turns_[i].empty()) put_inside(i, pieces[i]);
    }
    return pieces;
  }
  // Moves a piece that second-order effects of its turn put outside its room back to the room's edge.
  void put_inside(std::size_t index, Piece& piece) const {
    const Marker& marker = scene_.marker;
    const Box box = box_of(oriented(marker.shapes[piece.shape.value].outline, piece.orientation));
    const Box fit = minkowski::inner_fit(box, scene_.pieces.room(index, marker.strip, kLatticeLimit));
    piece.at.x = std::max(fit.low.x, std::min(piece.at.x, fit.high.x));
    piece.at.y = std::max(fit.low.y, std::min(piece.at.y, fit.high.y));
  }

  const scene::Scene& scene_;
  const TiltStepTuning& tuning_;
  double farthest_;
  double turn_;
  std::vector<model::tilting::TurnRange> turns_;
  model::tilting::TiltModel model_;
};

}  // namespace

TiltStep tilt_step(const scene::Scene& scene, const step::Goal& goal, std::span<const double> torque,
                   const TiltStepSettings& settings, const scene::Run& run) {
  Program program{scene, settings};
  program.add_goal(goal, torque);
  if (!program.add_pairs(run)) return {lp::LpStatus::kStopped, {}};
  run.observer.on_stage(scene::Stage::kSolve);
  run.observer.on_program(program.program());
  return program.solved(settings.solver, run);
}

}  // namespace selvage::motion::tilting
