#include "core/planning/lays.h"

#include <algorithm>

#include "core/planning/program/remnants.h"

namespace selvage::planning {
namespace {

// Fills lays with units of one marker.
class LayBuilder {
 public:
  LayBuilder(const orders::Problem& problem, std::size_t marker, std::vector<Lay>& lays)
      : problem_{problem}, marker_{marker}, lays_{lays} {}

  // `remnant`: its place; the number of remnants for plies from rolls.
  void add(std::size_t colour, int units, std::size_t remnant) {
    const std::size_t remnants = problem_.cloth.remnants.size();
    while (units > 0) {
      if (room_ == 0) {
        lays_.push_back({marker_, std::vector<int>(problem_.order.colours.size()), std::vector<int>(remnants)});
        room_ = problem_.units_of_lay();
      }
      const int spread = std::min(units, room_);
      lays_.back().plies[colour] += spread * problem_.plies_of_unit();
      if (remnant < remnants) lays_.back().on_remnants[remnant] += spread * problem_.plies_of_unit();
      units -= spread;
      room_ -= spread;
    }
  }

 private:
  const orders::Problem& problem_;
  std::size_t marker_;
  std::vector<Lay>& lays_;
  int room_{};
};

// Takes plies of one colour from rolls, one after the other.
class Spreading {
 public:
  explicit Spreading(const orders::Cloth& cloth) : cloth_{cloth} {}

  void spread(double ply) {
    rolls_.cloth += ply;
    if (cloth_.roll_length == 0) return;
    if (rolls_.left <= cloth_.splice_loss && rolls_.left < ply) {
      rolls_.lost += rolls_.left;
      begin_roll();
    }
    if (ply > rolls_.left) {
      ply += cloth_.splice_loss - rolls_.left;
      rolls_.lost += cloth_.splice_loss;
      ++rolls_.splices;
      begin_roll();
    }
    rolls_.left -= ply;
  }
  [[nodiscard]] const Rolls& rolls() const { return rolls_; }

 private:
  void begin_roll() {
    ++rolls_.rolls;
    rolls_.left = cloth_.roll_length;
  }

  const orders::Cloth& cloth_;
  Rolls rolls_;
};

}  // namespace

std::vector<Lay> lays_of(const orders::Problem& problem, const program::Cutting& cutting) {
  const program::OnRemnants filled = program::spread_on_remnants(problem, cutting.uses);
  const std::vector<orders::Remnant>& remnants = problem.cloth.remnants;
  std::vector<Lay> lays;
  for (std::size_t marker = 0; marker < cutting.uses.size(); ++marker) {
    LayBuilder builder{problem, marker, lays};
    const std::vector<int>& units = cutting.uses[marker].units;
    for (std::size_t colour = 0; colour < units.size(); ++colour) {
      int left = units[colour];
      for (std::size_t r = 0; r < remnants.size(); ++r) {
        if (remnants[r].colour != colour) continue;
        builder.add(colour, filled.units[marker][r], r);
        left -= filled.units[marker][r];
      }
      builder.add(colour, left, remnants.size());
    }
  }
  return lays;
}

std::vector<Rolls> rolls_of(const orders::Problem& problem, const program::Cutting& cutting,
                            const std::vector<Lay>& lays) {
  std::vector<Rolls> rolls;
  for (std::size_t colour = 0; colour < problem.order.colours.size(); ++colour) {
    Spreading spreading{problem.cloth};
    for (const Lay& lay : lays) {
      int plies = lay.plies[colour];
      for (std::size_t r = 0; r < lay.on_remnants.size(); ++r) {
        if (problem.cloth.remnants[r].colour == colour) plies -= lay.on_remnants[r];
      }
      const double ply = cutting.uses[lay.marker].candidate.length + problem.cloth.end_loss;
      for (int k = 0; k < plies; ++k) spreading.spread(ply);
    }
    rolls.push_back(spreading.rolls());
  }
  return rolls;
}

}  // namespace selvage::planning
