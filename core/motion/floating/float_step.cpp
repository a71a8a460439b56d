#include "core/motion/floating/float_step.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/distance.h"
#include "core/marker/clearance.h"
#include "core/model/snap.h"

namespace selvage::motion::floating {
namespace {

constexpr int kAttempts = 24;  // programs in one round; between them pieces are tied together

class Attempt {
 public:
  Attempt(const scene::Scene& scene, const FloatAim& aim, std::span<const FloatGap> gaps, double trust,
          const scene::Run& run)
      : scene_{scene},
        aim_{aim},
        gaps_{gaps},
        trust_{trust},
        run_{run},
        ties_{with_match_sets(scene.ties, scene.pieces, scene.marker.strip)} {
    run_.observer.on_stage(scene::Stage::kRows);
    rows_ = width_rows(scene, aim, gaps, trust, run.stop);
    std::vector<double> widths;
    for (const FloatGap& gap : gaps) widths.push_back(gap.now);
    worth_ = worth_of(aim, gaps, widths, scene.pieces);
  }

  FloatStep run(lp::solver::SolverChoice solver) {
    FloatStep step;
    step.end = step::StepEnd::kNoGain;
    while (step.programs < kAttempts) {
      run_.observer.on_stage(scene::Stage::kRows);
      const FloatProgram program{scene_, ties_, aim_, gaps_, rows_, trust_};
      run_.observer.on_stage(scene::Stage::kSolve);
      run_.observer.on_program(program.program());
      const lp::LpSolution solution = solve(program.program(), solver, {}, run_.stop, *run_.executor);
      ++step.programs;
      if (solution.status != lp::LpStatus::kOptimal) {
        step.end = solution.status == lp::LpStatus::kStopped ? step::StepEnd::kStopped : step::StepEnd::kSolverFailed;
        return step;
      }
      if (step.programs == 1) step.loads = program.loads(solution);
      if (program.promised(solution) <= worth_) return step;
      run_.observer.on_stage(scene::Stage::kVerify);
      auto broken = try_moves(program.displacements(solution), step);
      if (broken.empty()) return step;
      if (step.programs > 1) {  // rounding would violate others next time: tie all pairs that it may
        for (const std::size_t k : program.uncertain(solution)) {
          if (other_piece(gaps_[k].gap)) broken.push_back(pair_of(gaps_[k].gap));
        }
      }
      tie(broken);
    }
    return step;
  }

 private:
  // Rounds and proves the moves.  Returns the pairs that rounding brings too close; if there are none and the moves
  // gain, they become those of the step.
  std::vector<marker::PiecePair> try_moves(const std::vector<RealVec>& moves, FloatStep& step) const {
    marker::PlacedPieces moved = scene_.pieces;
    moved.move_by(model::snapped(moves));
    auto broken = conflicts(moved);
    std::vector<double> widths;
    for (const FloatGap& gap : gaps_) {
      widths.push_back(width_within(gap.gap, moved, aim_.strip, aim_.most));
      const PieceId* other = other_piece(gap.gap);
      if (!other) continue;
      const marker::PiecePair pair = pair_of(gap.gap);
      if (gap.least <= moved.spacing(pair)) continue;
      const auto [p, q] = pair;
      if (marker::collide(moved.facing(p, q), moved.facing(q, p), gap.least)) broken.push_back(pair);
    }
    if (!broken.empty()) return broken;
    const double gain = worth_of(aim_, gaps_, widths, moved) - worth_;
    if (gain <= 0 || !inside(moved)) return {};
    step.end = step::StepEnd::kMoved;
    step.gain = gain;
    for (const RealVec& d : moves) step.farthest = std::max({step.farthest, std::abs(d.x), std::abs(d.y)});
    step.positions = moved.positions();
    return {};
  }
  [[nodiscard]] bool inside(const marker::PlacedPieces& moved) const {
    const auto wide_enough = [&](const FloatGap& gap) {
      return other_piece(gap.gap) || whole_width_within(gap.gap, moved, aim_.strip, gap.least) >= gap.least;
    };
    return are_inside(moved, aim_.strip) && std::all_of(gaps_.begin(), gaps_.end(), wide_enough);
  }

  // Pieces that rounding brings too close to each other move as one, so that they stay as far apart as they are.
  void tie(const std::vector<marker::PiecePair>& broken) {
    for (const auto& [p, q] : broken) ties_.join(p, q);
  }

  const scene::Scene& scene_;
  const FloatAim& aim_;
  std::span<const FloatGap> gaps_;
  double trust_;
  const scene::Run& run_;
  model::Ties ties_;
  std::vector<WidthRow> rows_;
  double worth_{};
};

}  // namespace

FloatStep float_step(const scene::Scene& scene, const FloatAim& aim, std::span<const FloatGap> gaps, double trust,
                     lp::solver::SolverChoice solver, const scene::Run& run) {
  return Attempt{scene, aim, gaps, trust, run}.run(solver);
}

}  // namespace selvage::motion::floating
