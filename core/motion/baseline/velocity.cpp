#include "core/motion/baseline/velocity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/lp/solver/solve.h"
#include "core/marker/clearance.h"
#include "core/model/pair_rows.h"
#include "core/model/snap.h"
#include "core/motion/baseline/collision.h"

namespace selvage::motion::baseline {
namespace {

// Two pieces that may collide within the horizon.
struct Near {
  marker::PiecePair pair;
  minkowski::Obstacle obstacle;
};

// n . (velocity of the second - velocity of the first) >= bound  [Li94 (2.1), (2.2)]
struct ContactRow {
  marker::PiecePair pair;
  double nx{}, ny{}, bound{};
};

class Simulation {
 public:
  Simulation(scene::Scene& scene, const VelocitySettings& settings, const scene::Run& run)
      : scene_{scene},
        settings_{settings},
        run_{run},
        horizon_{settings.horizon * static_cast<double>(scene.marker.strip.width)},
        touching_{std::max(settings.tuning.least_touching,
                           settings.touching * static_cast<double>(scene.marker.strip.width))},
        start_{scene.pieces.positions()},
        moved_(start_.size()),
        longest_{scene.pieces.length()},
        piston_{static_cast<double>(longest_)},
        x_(start_.size(), kNone),
        y_(start_.size(), kNone),
        best_{start_},
        best_length_{longest_} {}

  // Leaves the scene at the shortest marker met.
  scene::StopReason run(int& steps, int& programs) {
    const scene::StopReason reason = simulate(steps, programs);
    scene_.pieces.place(best_);
    return reason;
  }

 private:
  scene::StopReason simulate(int& steps, int& programs) {
    int short_steps = 0;
    while (steps < settings_.steps) {
      if (run_.stopped()) return scene::StopReason::kCancelled;
      find_near();
      if (run_.stopped()) return scene::StopReason::kCancelled;
      const auto velocity = solve_velocities(programs);
      if (run_.stopped()) return scene::StopReason::kCancelled;
      if (!velocity) return scene::StopReason::kSolverFailed;
      if (-piston_velocity_ < settings_.least_speed) return scene::StopReason::kConverged;
      run_.observer.on_stage(scene::Stage::kOther);
      const double time = next_collision(*velocity);
      if (!advance(*velocity, time)) return scene::StopReason::kConverged;
      ++steps;
      run_.observer.on_round({steps, scene_.pieces.length()});
      short_steps = time < settings_.least_time * static_cast<double>(scene_.marker.strip.width) ? short_steps + 1 : 0;
      if (short_steps >= settings_.patience) return scene::StopReason::kConverged;
    }
    return scene::StopReason::kWorkLimit;
  }

  void find_near() {
    run_.observer.on_stage(scene::Stage::kSums);
    near_.clear();
    for (const marker::PiecePair& pair :
         pairs_within(scene_.pieces, std::llround(2 * horizon_) + scene_.pieces.widest_spacing())) {
      if (scene_.ties.joined(pair.first, pair.second)) continue;
      auto obstacle = scene_.obstacle(pair, run_.stop);
      if (!obstacle || run_.stopped()) return;
      near_.push_back({pair, *std::move(obstacle)});
    }
  }

  [[nodiscard]] const VelocityTuning& tuning() const { return settings_.tuning; }
  [[nodiscard]] double clearance(marker::PiecePair pair) const {
    return static_cast<double>(scene_.pieces.spacing(pair)) + tuning().clearance;
  }
  [[nodiscard]] FinePosition relative(marker::PiecePair pair) const {
    const double x = moved_[pair.second].x - moved_[pair.first].x;
    const double y = moved_[pair.second].y - moved_[pair.first].y;
    const Vec whole{std::llround(x), std::llround(y)};
    return {start_[pair.second] - start_[pair.first] + whole,
            {x - static_cast<double>(whole.x), y - static_cast<double>(whole.y)}};
  }

  // The touching pairs [Li94 2.3, 2.6], reduced to those that bound a free region of this reach.
  [[nodiscard]] std::vector<ContactRow> contact_rows() const {
    std::vector<ContactRow> rows;
    for (const Near& near : near_) {
      const Coord spacing = scene_.pieces.spacing(near.pair);
      const model::RegionSettings region{model::RegionRule::kGreedy,
                                         clearance(near.pair) + touching_ + tuning().least_touching, spacing};
      const FinePosition r = relative(near.pair);
      const Coord apart = std::max(spacing, Coord{0});
      for (const model::FreeSide& side : model::free_sides({near.obstacle, r.at, r.at, spacing - apart}, region)) {
        const auto [nx, ny] = side.normal;
        const double slack = side.slack + nx * r.rest.x + ny * r.rest.y - static_cast<double>(apart);
        if (slack > tuning().clearance + touching_ + tuning().least_touching) continue;
        const double lost = side.slanted() ? std::max(0.0, tuning().clearance - slack) : 0;
        rows.push_back({near.pair, nx, ny, lost / tuning().restoring});
      }
    }
    return rows;
  }

  std::optional<std::vector<RealVec>> solve_velocities(int& programs) {
    run_.observer.on_stage(scene::Stage::kRows);
    const std::vector<ContactRow> rows = contact_rows();
    for (const double restoring : {1.0, 0.0}) {  // if there is no room for the clearance, at least keep the present one
      run_.observer.on_stage(scene::Stage::kSolve);
      const lp::LinearProgram program = velocity_program(rows, restoring);
      run_.observer.on_program(program);
      const lp::LpSolution solution = solve(program, settings_.solver, {}, run_.stop, *run_.executor);
      ++programs;
      if (solution.status == lp::LpStatus::kStopped) return std::nullopt;
      if (solution.status != lp::LpStatus::kOptimal) continue;
      std::vector<RealVec> velocity(start_.size());
      for (std::size_t i = 0; i < velocity.size(); ++i) {
        const auto speed = [&](int column) { return column < 0 ? 0 : solution.x[static_cast<std::size_t>(column)]; };
        velocity[i] = {speed(x_[i]), speed(y_[i])};
      }
      piston_velocity_ = solution.x.back();
      return velocity;
    }
    return std::nullopt;
  }

  // Columns: the velocities of pieces that are free to have them, x and y, and last the piston's.
  [[nodiscard]] lp::LinearProgram velocity_program(const std::vector<ContactRow>& rows, double restoring) {
    lp::LinearProgram program;
    add_pieces(program);
    const int piston = program.add_column(1, -tuning().fastest, 0);
    for (std::size_t i = 0; i < start_.size(); ++i) {
      if (walls(i).right > touching_) continue;
      const std::array<lp::LinearProgram::Entry, 2> entries{{{piston, 1}, {x_[i], -1}}};
      program.add_row(std::span{entries}.first(x_[i] < 0 ? 1 : 2), 0);
    }
    for (const ContactRow& row : rows) {
      std::array<lp::LinearProgram::Entry, 4> entries{};
      std::size_t count = 0;
      const auto put = [&](const std::vector<int>& columns, double n) {
        const int p = columns[row.pair.first];
        const int q = columns[row.pair.second];
        if (p == q || n == 0) return;
        if (p >= 0) entries[count++] = {p, -n};
        if (q >= 0) entries[count++] = {q, n};
      };
      put(x_, row.nx);
      put(y_, row.ny);
      program.add_row(std::span{entries}.first(count), restoring * row.bound);
    }
    return program;
  }
  // Pieces tied to each other share a column; at an edge of the strip a piece can only move away from it.
  void add_pieces(lp::LinearProgram& program) {
    const double gravity = settings_.gravity / static_cast<double>(start_.size());
    std::vector<int> x_of(start_.size(), kNone);  // by tie
    std::vector<int> y_of(start_.size(), kNone);
    const auto add = [&](int& column, double cost, bool at_low, bool at_high) {
      if (column == kNone) column = program.add_column(0, -tuning().fastest, tuning().fastest);
      const auto c = static_cast<std::size_t>(column);
      program.cost[c] += cost;
      if (at_low) program.lower[c] = 0;
      if (at_high) program.upper[c] = 0;
      return column;
    };
    for (std::size_t i = 0; i < start_.size(); ++i) {
      const Walls room = walls(i);
      const std::uint32_t x = scene_.ties.x[i];
      const std::uint32_t y = scene_.ties.y[i];
      x_[i] = x == model::Ties::kFixed ? kNone : add(x_of[x], gravity, room.left <= touching_, room.end <= touching_);
      y_[i] = y == model::Ties::kFixed ? kNone : add(y_of[y], 0, room.bottom <= touching_, room.top <= touching_);
    }
  }

  // How far a piece is from the edges of its room, and from the piston.
  struct Walls {
    double left{}, right{}, bottom{}, top{}, end{};
  };
  [[nodiscard]] Walls walls(std::size_t i) const {
    const Box box = scene_.pieces[i].box.moved(start_[i]);
    const Box room = scene_.pieces.room(i, scene_.marker.strip, kLatticeLimit);
    const auto way = [](Coord from, Coord to) { return static_cast<double>(to - from); };
    const Coord end = scene_.pieces.is_zone(i) ? 0 : box.high.x;
    return {way(room.low.x, box.low.x) + moved_[i].x, piston_ - static_cast<double>(end) - moved_[i].x,
            way(room.low.y, box.low.y) + moved_[i].y, way(box.high.y, room.high.y) - moved_[i].y,
            way(box.high.x, room.high.x) - moved_[i].x};
  }

  // [Li94 2.2.2]
  [[nodiscard]] double next_collision(const std::vector<RealVec>& velocity) const {
    double time = horizon_;
    for (const Near& near : near_) {
      const double reach = clearance(near.pair);
      const auto& [p, q] = near.pair;
      const RealVec towards{velocity[q].x - velocity[p].x, velocity[q].y - velocity[p].y};
      if (scene_.pieces.spacing(near.pair) < 0) {
        time = std::min(time, time_in_region(near, towards));
        continue;
      }
      time = collision_time(near.obstacle, relative(near.pair), towards, {reach, reach + touching_, time});
    }
    const auto meet = [&](double room, double speed) {
      if (room > touching_ && speed > 0) time = std::min(time, room / speed);
    };
    for (std::size_t i = 0; i < start_.size(); ++i) {
      const Walls room = walls(i);
      meet(room.left, -velocity[i].x);
      meet(room.bottom, -velocity[i].y);
      meet(room.top, velocity[i].y);
      meet(room.end, velocity[i].x);
      meet(room.right, velocity[i].x - piston_velocity_);
    }
    return time;
  }

  // The time until a pair that may overlap leaves its free region: before that, it does not overlap by more than it
  // may.
  [[nodiscard]] double time_in_region(const Near& near, RealVec towards) const {
    const FinePosition r = relative(near.pair);
    double time = horizon_;
    const model::RegionSettings region{model::RegionRule::kGreedy, 2 * horizon_, 0};
    for (const model::FreeSide& side :
         model::free_sides({near.obstacle, r.at, r.at, scene_.pieces.spacing(near.pair)}, region)) {
      const auto [nx, ny] = side.normal;
      const double room = side.slack + nx * r.rest.x + ny * r.rest.y - tuning().clearance;
      const double approach = -(nx * towards.x + ny * towards.y);
      if (room > touching_ && approach > 0) time = std::min(time, room / approach);
    }
    return time;
  }

  // Advances by this time, or by most of it when rounding to the lattice makes its end invalid.
  bool advance(const std::vector<RealVec>& velocity, double time) {
    run_.observer.on_stage(scene::Stage::kVerify);
    for (const double part : {1.0, 1 - 1e-3, 0.5, 0.1}) {
      std::vector<RealVec> moved = moved_;
      for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] = {moved[i].x + part * time * velocity[i].x, moved[i].y + part * time * velocity[i].y};
      }
      if (!proved(moved)) continue;
      moved_ = std::move(moved);
      piston_ += part * time * piston_velocity_;
      return true;
    }
    return false;
  }
  bool proved(const std::vector<RealVec>& moved) {
    marker::PlacedPieces pieces = scene_.pieces;
    std::vector<Vec> positions = model::snapped(moved);
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = positions[i] + start_[i];
    pieces.place(std::move(positions));
    if (pieces.length() > longest_ || !all_clear(pieces, scene_.marker.strip)) return false;
    scene_.pieces = std::move(pieces);
    if (scene_.pieces.length() < best_length_) {
      best_length_ = scene_.pieces.length();
      best_ = scene_.pieces.positions();
    }
    return true;
  }

  scene::Scene& scene_;
  const VelocitySettings& settings_;
  const scene::Run& run_;
  double horizon_;              // units of time, at tuning().fastest as many lattice units
  double touching_;             // lattice units beyond the clearance; nearer is contact
  std::vector<Vec> start_;      // positions of the pieces at the start,
  std::vector<RealVec> moved_;  // and their displacements since then; not rounded
  Coord longest_;
  double piston_;  // its position
  double piston_velocity_{};
  static constexpr int kNone = -1;
  std::vector<int> x_, y_;  // the columns of each piece; kNone when it cannot move that way
  std::vector<Near> near_;
  std::vector<Vec> best_;
  Coord best_length_;
};

}  // namespace

Result<compaction::Compaction> compact_by_velocities(const Marker& start, const VelocitySettings& settings,
                                                     const scene::Run& run) {
  return compaction::shortened(start, run, [&](scene::Scene& scene) {
    compaction::Progress progress;
    progress.reason = Simulation{scene, settings, run}.run(progress.rounds, progress.programs);
    return progress;
  });
}

}  // namespace selvage::motion::baseline
