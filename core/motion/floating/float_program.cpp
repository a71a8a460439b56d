#include "core/motion/floating/float_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace selvage::motion::floating {
namespace {

constexpr double kShortfallCost = 10;  // of a unit of missing distance, beside all pieces moving by a unit each
constexpr double kCost = 0.01;      // of a unit of width, when each gap has its own: keeps duals, which add up, about 1
constexpr double kCertain = 0.01;   // lattice units: a solver's rounding is less
constexpr std::size_t kMeanOf = 8;  // columns in one row of a mean
constexpr double kMeanSlack = 1e-3;  // column units by which a mean may be off: equations have no interior

bool has_shared_width(FloatMode mode) {
  return mode == FloatMode::kLargestMinimum || mode == FloatMode::kTwoStep;
}
double shortfall_cost(std::size_t pieces) {
  return kShortfallCost * static_cast<double>(pieces);
}

// The row to an edge: its normal points into the strip.
WidthRow edge_row(std::size_t index, StripEdge edge, double width) {
  switch (edge) {
    case StripEdge::kLeft: return {index, 1, 0, width, 0};
    case StripEdge::kRight: return {index, -1, 0, width, 0};
    case StripEdge::kBottom: return {index, 0, 1, width, 0};
    case StripEdge::kTop: break;
  }
  return {index, 0, -1, width, 0};
}

RealVec between_centres(const Box& from, const Box& to) {
  return {static_cast<double>(to.low.x + to.high.x - from.low.x - from.high.x),
          static_cast<double>(to.low.y + to.high.y - from.low.y - from.high.y)};
}

double motion_of(const marker::PlacedPieces& pieces, std::span<const Vec> start) {
  double sum = 0;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Vec by = pieces.at(i) - start[i];
    sum += static_cast<double>(std::abs(by.x) + std::abs(by.y));
  }
  return sum;
}

double uniformity(std::span<const double> widths) {  // [Li94 7.2], negated
  const double sum = std::accumulate(widths.begin(), widths.end(), 0.0);
  const double mean = sum / static_cast<double>(widths.size());
  return std::accumulate(widths.begin(), widths.end(), sum, [&](double w, double d) { return w - std::abs(d - mean); });
}

}  // namespace

double worth_of(const FloatAim& aim, std::span<const FloatGap> gaps, std::span<const double> widths,
                const marker::PlacedPieces& pieces) {
  std::vector<double> wanted;
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (!gaps[k].held) wanted.push_back(widths[k]);
  }
  if (wanted.empty()) return 0;
  if (has_shared_width(aim.mode)) return *std::min_element(wanted.begin(), wanted.end());
  if (aim.mode == FloatMode::kUniform) return uniformity(wanted);
  const double sum = std::accumulate(wanted.begin(), wanted.end(), 0.0);
  if (aim.mode == FloatMode::kLargestTotal) return sum;
  return shortfall_cost(pieces.size()) * sum - motion_of(pieces, aim.start);
}

std::vector<WidthRow> width_rows(const scene::Scene& scene, const FloatAim& aim, std::span<const FloatGap> gaps,
                                 double trust, const std::stop_token& stop) {
  std::vector<WidthRow> rows;
  const model::ModelUnit unit{scene.marker.strip};
  for (std::size_t k = 0; k < gaps.size() && !stop.stop_requested(); ++k) {
    const FloatGap& gap = gaps[k];
    if (!other_piece(gap.gap)) {
      const double width = width_within(gap.gap, scene.pieces, aim.strip, static_cast<double>(kLatticeLimit));
      rows.push_back(edge_row(k, std::get<StripEdge>(gap.gap.opposite), width));
      continue;
    }
    const marker::PiecePair pair = pair_of(gap.gap);
    const Vec r = scene.relative_position(pair);
    const RealVec apart = between_centres(scene.pieces.box(pair.first), scene.pieces.box(pair.second));
    const auto now = static_cast<Coord>(gap.now);
    const Coord overlap = std::max(-now, Coord{0});
    const model::RegionSettings region{model::RegionRule::kGreedy, 3 * trust + aim.most, std::max(now, Coord{0}),
                                       apart};
    const auto obstacle = scene.obstacle(pair, stop);
    if (!obstacle) return rows;
    for (const model::FreeSide& side : free_sides({*obstacle, r, r, -overlap}, region)) {
      WidthRow row{k, 0, 0, side.slack - static_cast<double>(overlap), 0};
      const model::PairRow moved = row_of(pair, side, unit, model::TightRows::kRestore);
      row.nx = moved.nx;
      row.ny = moved.ny;
      row.margin = moved.bound + side.slack;
      const double approach = 2 * trust * (std::abs(row.nx) + std::abs(row.ny));
      if (row.slack - row.margin < aim.most + approach) rows.push_back(row);
    }
  }
  return rows;
}

FloatProgram::FloatProgram(const scene::Scene& scene, const model::Ties& ties, const FloatAim& aim,
                           std::span<const FloatGap> gaps, std::span<const WidthRow> rows, double trust)
    : scene_{scene},
      ties_{ties},
      aim_{aim},
      gaps_{gaps},
      rows_{rows},
      model_{scene.pieces, aim.strip, ties},
      width_(gaps.size(), -1) {
  gap_of_row_.resize(model_.program().bound.size(), gaps.size());  // rows of no gap
  bound_motion(trust);
  add_widths();
  add_rows();
  if (aim.mode == FloatMode::kUniform) add_uniformity();
  if (aim.mode == FloatMode::kGivenDistance) add_motion();
  gap_of_row_.resize(model_.program().bound.size(), gaps.size());
}

void FloatProgram::bound_motion(double trust) {
  lp::LinearProgram& program = model_.program();
  const double limit = model_.unit().to_columns(trust);
  for (double& low : program.lower) low = std::max(low, -limit);
  for (double& high : program.upper) high = std::min(high, limit);
}

bool FloatProgram::tied(const Gap& gap) const {
  if (const PieceId* other = other_piece(gap)) return ties_.joined(gap.piece.value, other->value);
  const auto edge = std::get<StripEdge>(gap.opposite);
  const bool along = edge == StripEdge::kLeft || edge == StripEdge::kRight;
  return (along ? ties_.x : ties_.y)[gap.piece.value] == model::Ties::kFixed;
}

void FloatProgram::add_widths() {
  std::vector<double> room(gaps_.size(), aim_.most);  // what each gap has when nothing moves
  for (const WidthRow& row : rows_) room[row.gap] = std::min(room[row.gap], row.slack - row.margin);
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (tied(gaps_[k].gap)) room[k] = gaps_[k].now;
  }
  if (has_shared_width(aim_.mode)) add_shared_width(room);
  add_own_widths(room);
}

// One column for the least width of all gaps that are not held [Li94 7.4].
void FloatProgram::add_shared_width(std::span<const double> room) {
  double low = aim_.most;
  double high = aim_.most;
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (gaps_[k].held) continue;
    low = std::min(low, room[k]);
    if (tied(gaps_[k].gap)) high = std::min(high, gaps_[k].now);
  }
  const int shared = model_.program().add_column(-1, model_.unit().to_columns(low), model_.unit().to_columns(high));
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (!gaps_[k].held) width_[k] = shared;
  }
}

// A column for every other gap [Li94 7.6]; that of a held one stays where it is.
void FloatProgram::add_own_widths(std::span<const double> room) {
  const double cost = aim_.mode == FloatMode::kUniform ? 0 : -kCost;
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (width_[k] >= 0) continue;
    const FloatGap& gap = gaps_[k];
    double low = std::min(static_cast<double>(gap.least), room[k]);
    double high = aim_.most;
    if (gap.held) low = high = std::min(gap.keep, room[k]);
    if (tied(gap.gap)) low = high = room[k];
    width_[k] =
        model_.program().add_column(gap.held ? 0 : cost, model_.unit().to_columns(low), model_.unit().to_columns(high));
  }
}

void FloatProgram::add_rows() {
  for (const WidthRow& row : rows_) {
    const Gap& gap = gaps_[row.gap].gap;
    if (tied(gap)) continue;
    const PieceId* other = other_piece(gap);
    model::Terms entries = other ? model_.terms(other->value, gap.piece.value, row.nx, row.ny)
                                 : model_.terms(gap.piece.value, {}, row.nx, row.ny);
    entries.add(width_[row.gap], -1);
    model_.program().add_row(entries.all(), model_.unit().to_columns(row.margin - row.slack));
    gap_of_row_.push_back(row.gap);
  }
}

// A column that is the mean of others.  Their sum is taken a few at a time: one row with all of them would make the
// solver's matrix dense.
int FloatProgram::add_mean(std::span<const int> columns) {
  lp::LinearProgram& program = model_.program();
  std::vector<lp::LinearProgram::Entry> terms;
  for (const int column : columns) terms.push_back({column, 1});
  std::vector<double> counts(terms.size(), 1);  // how many columns each term is the mean of
  while (terms.size() > 1) {
    std::vector<lp::LinearProgram::Entry> means;
    std::vector<double> mean_counts;
    for (std::size_t k = 0; k < terms.size(); k += kMeanOf) {
      const std::size_t end = std::min(terms.size(), k + kMeanOf);
      const double count = std::accumulate(&counts[k], &counts[k] + (end - k), 0.0);
      const int mean = program.add_column(0, -lp::kInfinity, lp::kInfinity);
      for (const double sign : {1.0, -1.0}) {
        std::vector<lp::LinearProgram::Entry> entries{{mean, sign}};
        for (std::size_t m = k; m < end; ++m) entries.push_back({terms[m].column, -sign * counts[m] / count});
        program.add_row(entries, -kMeanSlack);
      }
      means.push_back({mean, 1});
      mean_counts.push_back(count);
    }
    terms = std::move(means);
    counts = std::move(mean_counts);
  }
  return terms.front().column;
}

// [Li94 7.2]: -J m + sum |d_j - m| with J m = sum d_j is sum l_j with l_j = |d_j - m| - d_j = max(-m, m - 2 d_j).
void FloatProgram::add_uniformity() {
  lp::LinearProgram& program = model_.program();
  std::vector<int> widths;
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    if (!gaps_[k].held) widths.push_back(width_[k]);
  }
  if (widths.empty()) return;
  const int mean = add_mean(widths);
  for (const int width : widths) {
    const int excess = program.add_column(kCost, -lp::kInfinity, lp::kInfinity);
    program.add_row(std::array<lp::LinearProgram::Entry, 2>{{{excess, 1}, {mean, 1}}}, 0);
    program.add_row(std::array<lp::LinearProgram::Entry, 3>{{{excess, 1}, {mean, -1}, {width, 2}}}, 0);
  }
}

// |x| and |y| of every piece's motion since the start [Li94 5.2].
void FloatProgram::add_motion() {
  lp::LinearProgram& program = model_.program();
  for (std::size_t i = 0; i < scene_.pieces.size(); ++i) {
    const Vec so_far = scene_.pieces.at(i) - aim_.start[i];
    for (const auto& [column, by] : {std::pair{model_.x_column(i), so_far.x}, {model_.y_column(i), so_far.y}}) {
      if (!column) continue;
      const int moving = *column;
      const double offset = model_.unit().to_columns(static_cast<double>(by));
      const int magnitude = program.add_column(kCost / shortfall_cost(scene_.pieces.size()), 0, lp::kInfinity);
      program.add_row(std::array<lp::LinearProgram::Entry, 2>{{{magnitude, 1}, {moving, -1}}}, offset);
      program.add_row(std::array<lp::LinearProgram::Entry, 2>{{{magnitude, 1}, {moving, 1}}}, -offset);
    }
  }
}

double FloatProgram::promised(const lp::LpSolution& solution) const {
  double scale = has_shared_width(aim_.mode) ? 1 : kCost;
  if (aim_.mode == FloatMode::kGivenDistance) scale /= shortfall_cost(scene_.pieces.size());
  return model_.unit().to_lattice(-solution.objective) / scale;
}

std::vector<std::size_t> FloatProgram::uncertain(const lp::LpSolution& solution) const {
  std::vector<std::size_t> gaps;
  for (std::size_t k = 0; k < gaps_.size(); ++k) {
    const double width = model_.unit().to_lattice(solution.x[static_cast<std::size_t>(width_[k])]);
    if (!tied(gaps_[k].gap) && width < static_cast<double>(gaps_[k].least) - kCertain) gaps.push_back(k);
  }
  return gaps;
}

std::vector<double> FloatProgram::loads(const lp::LpSolution& solution) const {
  std::vector<double> loads(gaps_.size());
  for (std::size_t r = 0; r < gap_of_row_.size() && r < solution.dual.size(); ++r) {
    if (gap_of_row_[r] < loads.size()) loads[gap_of_row_[r]] += solution.dual[r];
  }
  return loads;
}

}  // namespace selvage::motion::floating
