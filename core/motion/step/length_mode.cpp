#include "core/motion/step/length_mode.h"

#include <algorithm>
#include <cmath>

namespace selvage::motion::step {
namespace {

constexpr double kSolverTolerance = 1e-6;  // a motion may exceed its limit by this fraction of it

double right_of(const marker::PlacedPieces& pieces, std::size_t piece) {
  return static_cast<double>(pieces.end_of(piece));
}

// Calls visit(k, by, distance) for each near pair, the k-th, whose pieces move against each other by more than its
// motion.
template <class Visit>
void for_each_beyond(const NearPairs& near, const Moves& moves, const Visit& visit) {
  for (std::size_t k = 0; k < near.pairs().size(); ++k) {
    const RealVec by = relative(near.pairs()[k], moves.displacements);
    const double distance = std::max(std::abs(by.x), std::abs(by.y));
    if (distance > near.motion(near.pairs()[k]) * (1 + kSolverTolerance)) visit(k, by, distance);
  }
}

// Appends the rows by which the two pieces move against each other by at most `limit` on an axis, where they now move
// farther.
void append_limits(marker::PiecePair pair, RealVec by, double limit, std::vector<model::PairRow>& rows) {
  if (std::abs(by.x) > limit) rows.push_back({pair, by.x > 0 ? -1.0 : 1.0, 0, -limit});
  if (std::abs(by.y) > limit) rows.push_back({pair, 0, by.y > 0 ? -1.0 : 1.0, -limit});
}

class FixedLength final : public LengthMode {
 public:
  FixedLength(const scene::Scene& scene, const StepSettings& settings, const NearPairs& near)
      : scene_{scene}, settings_{settings}, near_{near} {}

  [[nodiscard]] model::PositionModel model(const model::Ties& ties) const override {
    return {scene_.pieces, scene_.marker.strip.ending(scene_.pieces.length()), ties};
  }

  void append_first_rows(std::vector<model::PairRow>& rows) const override {
    if (settings_.extent != model::Extent::kWhole) return;
    for (const marker::PiecePair& pair : near_.pairs()) {
      for (const auto& [nx, ny] : {std::pair{1.0, 0.0}, {-1.0, 0.0}, {0.0, 1.0}, {0.0, -1.0}}) {
        rows.push_back({pair, nx, ny, -near_.motion()});
      }
    }
  }

  [[nodiscard]] BrokenRows broken_by(const Moves& moves, const model::PositionModel& /*model*/,
                                     model::TightRows /*tight*/) const override {
    BrokenRows broken;
    for_each_beyond(near_, moves, [&](std::size_t k, RealVec by, double /*distance*/) {
      append_limits(near_.pairs()[k], by, near_.motion(), broken.rows);
    });
    return broken;
  }

  [[nodiscard]] std::vector<model::PairRow> limits_of_flights(const Moves& /*moves*/, double /*limit*/) const override {
    return {};
  }

 private:
  const scene::Scene& scene_;
  const StepSettings& settings_;
  const NearPairs& near_;
};

class Shortening final : public LengthMode {
 public:
  Shortening(const scene::Scene& scene, const Goal& goal, const StepSettings& settings, const NearPairs& near)
      : scene_{scene}, goal_{goal}, settings_{settings}, near_{near} {}

  [[nodiscard]] model::PositionModel model(const model::Ties& ties) const override {
    model::PositionModel model{scene_.pieces, scene_.marker.strip, ties};
    const auto length = static_cast<double>(scene_.pieces.length());
    model.add_length(goal_.shorten, length, model.unit().to_lattice(settings_.tuning.spare_length));
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      if (length - right_of(scene_.pieces, i) <= near_.motion()) model.add_right_wall(i);
    }
    return model;
  }

  // Gravity would take a piece that has no near pair on its left beyond every limit: it is limited from the first.
  void append_first_rows(std::vector<model::PairRow>& rows) const override {
    if (settings_.extent == model::Extent::kWhole) return;
    std::vector<char> limited(scene_.pieces.size());
    for (const model::PairRow& row : rows) {
      if (row.nx > 0) limited[row.pair.second] = 1;
      if (row.nx < 0) limited[row.pair.first] = 1;
    }
    for (const marker::PiecePair& pair : near_.pairs()) {
      char& first = limited[pair.first];
      char& second = limited[pair.second];
      if (first == second) continue;
      rows.push_back({pair, first == 0 ? -1.0 : 1.0, 0, -near_.motion()});
      first = second = 1;
    }
  }

  [[nodiscard]] BrokenRows broken_by(const Moves& moves, const model::PositionModel& model,
                                     model::TightRows tight) const override {
    BrokenRows broken;
    for_each_beyond(near_, moves, [&](std::size_t k, RealVec by, double distance) {
      std::vector<model::PairRow> rows;
      near_.append_rows(k, distance, tight, rows);
      std::copy_if(rows.begin(), rows.end(), std::back_inserter(broken.rows),
                   [&](const model::PairRow& row) { return along(row, by) < row.bound - settings_.tuning.broken; });
    });
    const double end = static_cast<double>(scene_.pieces.length()) + moves.length_change;
    for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
      const bool beyond = right_of(scene_.pieces, i) + moves.displacements[i].x > end;
      if (beyond && !model.has_right_wall(i)) broken.right_walls.push_back(i);
    }
    return broken;
  }

  [[nodiscard]] std::vector<model::PairRow> limits_of_flights(const Moves& moves, double limit) const override {
    std::vector<model::PairRow> rows;
    for_each_beyond(near_, moves, [&](std::size_t k, RealVec by, double distance) {
      if (distance > limit * (1 + kSolverTolerance)) append_limits(near_.pairs()[k], by, limit, rows);
    });
    return rows;
  }

 private:
  const scene::Scene& scene_;
  const Goal& goal_;
  const StepSettings& settings_;
  const NearPairs& near_;
};

}  // namespace

RealVec relative(marker::PiecePair pair, const std::vector<RealVec>& displacements) {
  const RealVec& first = displacements[pair.first];
  const RealVec& second = displacements[pair.second];
  return {second.x - first.x, second.y - first.y};
}

std::vector<RealVec> scaled(const std::vector<RealVec>& displacements, double fraction) {
  std::vector<RealVec> part = displacements;
  for (RealVec& d : part) d = {d.x * fraction, d.y * fraction};
  return part;
}

double farthest_relative(const std::vector<marker::PiecePair>& pairs, const std::vector<RealVec>& displacements) {
  double most = 0;
  for (const marker::PiecePair& pair : pairs) {
    const RealVec by = relative(pair, displacements);
    most = std::max({most, std::abs(by.x), std::abs(by.y)});
  }
  return most;
}

double feasible_fraction(const marker::PlacedPieces& pieces, const BrokenRows& broken, const Moves& moves) {
  double fraction = 1;
  for (const model::PairRow& row : broken.rows) {
    fraction = std::min(fraction, row.bound / along(row, relative(row.pair, moves.displacements)));
  }
  const auto length = static_cast<double>(pieces.length());
  for (const std::size_t i : broken.right_walls) {
    fraction = std::min(fraction, (length - right_of(pieces, i)) / (moves.displacements[i].x - moves.length_change));
  }
  return std::max(0.0, fraction);
}

std::unique_ptr<const LengthMode> length_mode(const scene::Scene& scene, const Goal& goal, const StepSettings& settings,
                                              const NearPairs& near) {
  if (goal.fixes_length()) return std::make_unique<FixedLength>(scene, settings, near);
  return std::make_unique<Shortening>(scene, goal, settings, near);
}

}  // namespace selvage::motion::step
