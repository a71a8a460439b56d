#include "tests/core/lp/compaction_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace selvage::lp {
namespace {

constexpr double kWidth = 1000;

// A random number generator that gives the same numbers with every standard library, unlike the standard distributions.
class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_{seed} {}
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

struct Point {
  double x{}, y{};
};

std::vector<Point> jittered_grid(const CompactionModel& model, double cell, Draw& draw) {
  std::vector<Point> points;
  for (int k = 0; k < model.points; ++k) {
    const double x = (k / model.across + 0.5) * cell;
    const double y = (k % model.across + 0.5) * cell;
    points.push_back({x + draw(-0.3, 0.3) * cell, y + draw(-0.3, 0.3) * cell});
  }
  return points;
}

void add_pair(LinearProgram& program, const CompactionModel& model, const std::vector<Point>& at, int p, int q,
              Draw& draw) {
  const Point a = at[static_cast<std::size_t>(p)];
  const Point b = at[static_cast<std::size_t>(q)];
  const double towards = std::atan2(b.y - a.y, b.x - a.x);
  const double apart = std::hypot(b.x - a.x, b.y - a.y);
  for (int k = 0; k < model.normals; ++k) {
    const double angle = towards + draw(-1, 1);
    const double nx = std::cos(angle);
    const double ny = std::sin(angle);
    const double slack = draw(0, 1) < model.tight ? 0 : draw(0, 0.3) * apart;
    const std::array<LinearProgram::Entry, 4> row{{{2 * p, -nx}, {2 * p + 1, -ny}, {2 * q, nx}, {2 * q + 1, ny}}};
    program.add_row(row, -slack);
  }
}

}  // namespace

LinearProgram compaction_program(const CompactionModel& model) {
  Draw draw{model.seed};
  const double cell = kWidth / model.across;
  const std::vector<Point> at = jittered_grid(model, cell, draw);
  LinearProgram program;
  for (const Point& point : at) {
    program.add_column(model.gravity / model.points, -point.x, kInfinity);
    program.add_column(0, -point.y, kWidth - point.y);
  }
  const int length = program.add_column(1, -kInfinity, kInfinity);
  const double present = std::max_element(at.begin(), at.end(), [](Point a, Point b) { return a.x < b.x; })->x;
  for (int p = 0; p < model.points; ++p) {
    for (const int step : {1, model.across, model.across + 1, model.across - 1}) {
      const int q = p + step;
      if (q >= model.points) continue;
      if (std::abs(q % model.across - p % model.across) > 1) continue;
      add_pair(program, model, at, p, q, draw);
    }
    const std::array<LinearProgram::Entry, 2> end{{{length, 1}, {2 * p, -1}}};
    program.add_row(end, at[static_cast<std::size_t>(p)].x - present);
  }
  return program;
}

}  // namespace selvage::lp
