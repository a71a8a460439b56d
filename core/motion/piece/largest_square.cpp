#include "core/motion/piece/largest_square.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

namespace selvage::motion::piece {
namespace {

constexpr double kTolerance = 1e-10;  // in units of the reach

// a . x <= b, in the first variables only.
struct Row {
  std::array<double, 3> a{};
  double b{};
};

// Maximise c . x over rows and bounds, in `dimension` variables.
struct Program {
  std::size_t dimension{};
  std::array<double, 3> c{}, low{}, high{};
  std::vector<Row> rows;
};
using Point = std::array<double, 3>;

double left_side(const Row& row, const Point& x, std::size_t dimension) {
  return std::inner_product(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(dimension), row.a.begin(), 0.0);
}

std::array<double, 3> without(const std::array<double, 3>& values, std::size_t k) {
  std::array<double, 3> rest{};
  std::size_t count = 0;
  for (std::size_t j = 0; j < 3; ++j) {
    if (j != k) rest[count++] = values[j];
  }
  return rest;
}

// Substitutes x_k = (b - sum of the others) / a_k in `row`.
Row eliminated(const Row& row, const Row& line, std::size_t k) {
  Row rest;
  const double factor = row.a[k] / line.a[k];
  for (std::size_t j = 0; j < 3; ++j) rest.a[j] = row.a[j] - factor * line.a[j];
  rest.a = without(rest.a, k);
  rest.b = row.b - factor * line.b;
  return rest;
}

// The program on the line (or plane) of row `on`, with the rows before it.
Program restricted(const Program& program, std::size_t on, std::size_t k) {
  const Row& line = program.rows[on];
  Program rest{program.dimension - 1, {}, without(program.low, k), without(program.high, k), {}};
  rest.c = eliminated({program.c, 0}, line, k).a;
  rest.rows.reserve(on + 2);
  Row bound;
  bound.a[k] = 1;
  bound.b = program.high[k];
  rest.rows.push_back(eliminated(bound, line, k));
  bound.a[k] = -1;
  bound.b = -program.low[k];
  rest.rows.push_back(eliminated(bound, line, k));
  for (std::size_t i = 0; i < on; ++i) rest.rows.push_back(eliminated(program.rows[i], line, k));
  return rest;
}

std::optional<Point> optimum(const Program& program) {
  const std::size_t dimension = program.dimension;
  Point x{};
  for (std::size_t j = 0; j < dimension; ++j) {
    x[j] = program.c[j] > 0 ? program.high[j] : program.c[j] < 0 ? program.low[j] : 0;
    x[j] = std::clamp(x[j], program.low[j], program.high[j]);
  }
  for (std::size_t i = 0; i < program.rows.size(); ++i) {
    const Row& row = program.rows[i];
    if (left_side(row, x, dimension) <= row.b + kTolerance * (1 + std::abs(row.b))) continue;
    std::size_t k = 0;
    for (std::size_t j = 1; j < dimension; ++j) {
      if (std::abs(row.a[j]) > std::abs(row.a[k])) k = j;
    }
    if (std::abs(row.a[k]) < kTolerance) return std::nullopt;
    Point rest{};
    if (dimension > 1) {
      const auto found = optimum(restricted(program, i, k));
      if (!found) return std::nullopt;
      rest = *found;
    }
    std::size_t count = 0;
    for (std::size_t j = 0; j < dimension; ++j) x[j] = j == k ? 0 : rest[count++];
    x[k] = (row.b - left_side(row, x, dimension)) / row.a[k];
    if (dimension > 1) continue;
    // In one variable, the rows before this one have not been checked again.
    for (std::size_t before = 0; before < i; ++before) {
      const Row& other = program.rows[before];
      if (other.a[0] * x[0] > other.b + kTolerance * (1 + std::abs(other.b))) return std::nullopt;
    }
    if (x[0] < program.low[0] - kTolerance || x[0] > program.high[0] + kTolerance) return std::nullopt;
  }
  return x;
}

}  // namespace

Square largest_square(std::span<const CellSide> cell, double reach) {
  std::vector<const CellSide*> nearest_first;
  for (const CellSide& side : cell) nearest_first.push_back(&side);
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [](const CellSide* a, const CellSide* b) { return a->slack < b->slack; });
  // The square about the origin, which need not be the largest, is a lower bound.
  const double least = nearest_first.empty() ? 0 : std::min(0.0, nearest_first.front()->slack / reach);
  Program program{3, {0, 0, 1}, {-1, -1, least - 1}, {1, 1, 1}, {}};
  program.rows.reserve(cell.size());
  for (const CellSide* side : nearest_first) {
    // All corners (x +- l, y +- l) inside [Li94 6.1]: the worst one decides.
    program.rows.push_back({{-side->nx, -side->ny, std::abs(side->nx) + std::abs(side->ny)}, side->slack / reach});
  }
  const auto best = optimum(program);
  if (!best) return {{}, least * reach};  // only by rounding: the square about the origin is always feasible
  return {{(*best)[0] * reach, (*best)[1] * reach}, (*best)[2] * reach};
}

}  // namespace selvage::motion::piece
