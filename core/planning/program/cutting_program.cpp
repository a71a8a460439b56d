#include "core/planning/program/cutting_program.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/planning/program/remnants.h"

namespace selvage::planning::program {
namespace {

using Entry = lp::LinearProgram::Entry;

int whole(double value) {
  return static_cast<int>(std::lround(value));
}

}  // namespace

CuttingProgram::CuttingProgram(const orders::Problem& problem, std::vector<Candidate> candidates, int fewest)
    : problem_{problem}, candidates_{std::move(candidates)} {
  std::sort(candidates_.begin(), candidates_.end(),
            [](const Candidate& a, const Candidate& b) { return a.ratio < b.ratio; });
  for (const Candidate& candidate : candidates_) add_candidate(candidate);
  for (std::size_t k = 0; k < candidates_.size(); ++k) add_remnants(k);
  add_remnant_lengths();
  add_deliveries();
  add_counts(fewest);
}

void CuttingProgram::add_candidate(const Candidate& candidate) {
  const Price price = price_of(problem_, candidate);
  Columns& columns = columns_.emplace_back();
  columns.units.assign(price.most.size(), -1);
  if (price.most_units == 0) return;
  const int per_lay = problem_.units_of_lay();
  const int most_lays = (price.most_units + per_lay - 1) / per_lay;
  columns.lays = program_.add_whole_column(price.lay, 0, most_lays);
  columns.chosen = program_.add_whole_column(price.marker, 0, 1);
  std::vector<Entry> room{{columns.lays, static_cast<double>(per_lay)}};
  for (std::size_t colour = 0; colour < price.most.size(); ++colour) {
    const int most = price.most[colour];
    if (most == 0) continue;
    const int column = columns.units[colour] = program_.add_whole_column(price.unit, 0, most);
    room.push_back({column, -1});
    const Entry row[] = {{columns.chosen, static_cast<double>(most)}, {column, -1}};
    program_.linear.add_row(row, 0);
  }
  program_.linear.add_row(room, 0);
  const Entry row[] = {{columns.lays, 1}, {columns.chosen, -1}};
  program_.linear.add_row(row, 0);
}

void CuttingProgram::add_remnants(std::size_t candidate) {
  const std::vector<orders::Remnant>& remnants = problem_.cloth.remnants;
  Columns& columns = columns_[candidate];
  columns.on_remnants.assign(remnants.size(), -1);
  const double length = problem_.unit_length(candidates_[candidate].length);
  for (std::size_t colour = 0; colour < columns.units.size(); ++colour) {
    if (columns.units[colour] < 0) continue;
    std::vector<Entry> row{{columns.units[colour], 1}};
    for (std::size_t r = 0; r < remnants.size(); ++r) {
      const int most = remnants[r].colour == colour ? units_held(problem_, remnants[r], length) : 0;
      if (most == 0) continue;
      columns.on_remnants[r] = program_.add_whole_column(-problem_.remnant_saving() * length, 0, most);
      row.push_back({columns.on_remnants[r], -1});
    }
    if (row.size() > 1) program_.linear.add_row(row, 0);
  }
}

void CuttingProgram::add_remnant_lengths() {
  const std::vector<orders::Remnant>& remnants = problem_.cloth.remnants;
  for (std::size_t r = 0; r < remnants.size(); ++r) {
    std::vector<Entry> row;
    for (std::size_t k = 0; k < candidates_.size(); ++k) {
      const int column = columns_[k].on_remnants[r];
      if (column >= 0) row.push_back({column, -problem_.unit_length(candidates_[k].length)});
    }
    if (!row.empty()) program_.linear.add_row(row, -remnants[r].length);
  }
}

void CuttingProgram::add_counts(int fewest) {
  std::vector<Entry> markers, lays;
  for (const Columns& columns : columns_) {
    if (columns.lays < 0) continue;
    markers.push_back({columns.chosen, 1});
    lays.push_back({columns.lays, 1});
  }
  program_.linear.add_row(markers, fewest);
  const std::int64_t of_unit = problem_.limits.bundles * problem_.plies_of_unit();
  std::int64_t units = 0;
  for (std::size_t colour = 0; colour < problem_.order.colours.size(); ++colour) {
    std::int64_t garments = 0;
    for (std::size_t size = 0; size < problem_.order.sizes.size(); ++size) garments += problem_.least(colour, size);
    units += (garments + of_unit - 1) / of_unit;
  }
  const std::int64_t fewest_lays = (units + problem_.units_of_lay() - 1) / problem_.units_of_lay();
  program_.linear.add_row(lays, static_cast<double>(fewest_lays));
}

void CuttingProgram::add_deliveries() {
  const orders::Order& order = problem_.order;
  for (std::size_t colour = 0; colour < order.colours.size(); ++colour) {
    for (std::size_t size = 0; size < order.sizes.size(); ++size) {
      if (order.garments[colour][size] == 0) continue;
      std::vector<Entry> row;
      for (std::size_t k = 0; k < candidates_.size(); ++k) {
        const int column = columns_[k].units[colour], bundles = candidates_[k].ratio[size];
        if (column >= 0 && bundles > 0) row.push_back({column, 1.0 * bundles * problem_.plies_of_unit()});
      }
      program_.linear.add_row(row, problem_.least(colour, size));
      for (Entry& entry : row) entry.value = -entry.value;
      program_.linear.add_row(row, -problem_.most(colour, size));
    }
  }
}

Cutting CuttingProgram::cutting_of(std::span<const double> x) const {
  Cutting cutting;
  for (std::size_t k = 0; k < candidates_.size(); ++k) {
    Use use{candidates_[k], std::vector<int>(problem_.order.colours.size())};
    for (std::size_t colour = 0; colour < use.units.size(); ++colour) {
      const int column = columns_[k].units[colour];
      if (column >= 0) use.units[colour] = whole(x[static_cast<std::size_t>(column)]);
    }
    if (std::any_of(use.units.begin(), use.units.end(), [](int units) { return units > 0; }))
      cutting.uses.push_back(std::move(use));
  }
  cutting.cost = cost_of(problem_, cutting.uses);
  return cutting;
}

std::vector<double> CuttingProgram::solution_of(const Cutting& cutting) const {
  std::vector<double> x(program_.linear.cost.size());
  const OnRemnants filled = spread_on_remnants(problem_, cutting.uses);
  for (std::size_t u = 0; u < cutting.uses.size(); ++u) {
    const Use& use = cutting.uses[u];
    const auto found =
        std::lower_bound(candidates_.begin(), candidates_.end(), use.candidate.ratio,
                         [](const Candidate& one, const orders::Ratio& ratio) { return one.ratio < ratio; });
    if (found == candidates_.end() || found->ratio != use.candidate.ratio) return {};
    const Columns& columns = columns_[static_cast<std::size_t>(found - candidates_.begin())];
    for (std::size_t colour = 0; colour < use.units.size(); ++colour) {
      if (use.units[colour] > 0) x[static_cast<std::size_t>(columns.units[colour])] = use.units[colour];
    }
    x[static_cast<std::size_t>(columns.lays)] = lays_of(problem_, use);
    x[static_cast<std::size_t>(columns.chosen)] = 1;
    for (std::size_t r = 0; r < filled.units[u].size(); ++r) {
      if (filled.units[u][r] > 0) x[static_cast<std::size_t>(columns.on_remnants[r])] = filled.units[u][r];
    }
  }
  return x;
}

}  // namespace selvage::planning::program
