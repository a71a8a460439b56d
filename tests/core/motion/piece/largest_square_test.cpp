#include "core/motion/piece/largest_square.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "core/lp/interior_point/interior_point.h"

namespace selvage::motion::piece {
namespace {

CellSide side(double x, double y, double slack) {
  const double length = std::hypot(x, y);
  return {x / length, y / length, slack};
}

TEST(LargestSquare, FillsABox) {
  const std::vector<CellSide> box{{1, 0, 10}, {-1, 0, 30}, {0, 1, 50}, {0, -1, 50}};
  const Square square = largest_square(box, 1000);
  EXPECT_NEAR(square.centre.x, 10, 1e-6);
  EXPECT_NEAR(square.centre.y, 0, 30 + 1e-6);
  EXPECT_NEAR(square.half, 20, 1e-6);
}

TEST(LargestSquare, FitsIntoATriangle) {  // below x + y = 0, right of x = -100, above y = -100
  const std::vector<CellSide> triangle{side(-1, -1, 0), {1, 0, 100}, {0, 1, 100}};
  const Square square = largest_square(triangle, 1000);
  EXPECT_NEAR(square.centre.x, -50, 1e-6);
  EXPECT_NEAR(square.centre.y, -50, 1e-6);
  EXPECT_NEAR(square.half, 50, 1e-6);
}

TEST(LargestSquare, ReportsByHowMuchAnEmptyCellIsInfeasible) {
  const std::vector<CellSide> empty{{1, 0, -30}, {-1, 0, 10}};
  const Square square = largest_square(empty, 1000);
  EXPECT_NEAR(square.half, -10, 1e-6);
  EXPECT_NEAR(square.centre.x, 20, 1e-6);
}

TEST(LargestSquare, IsLimitedToItsReach) {
  EXPECT_EQ(largest_square({}, 100).half, 100);
  const std::vector<CellSide> far{{1, 0, -500}};
  const Square square = largest_square(far, 100);
  EXPECT_NEAR(square.centre.x, 100, 1e-6);
  EXPECT_NEAR(square.half, -400, 1e-6);
}

// The same program, by another method.
double by_interior_point(const std::vector<CellSide>& cell, double reach) {
  lp::LinearProgram program;
  // In units of the reach, which suits solvers.
  program.add_column(0, -1, 1);
  program.add_column(0, -1, 1);
  program.add_column(-1, -lp::kInfinity, 1);
  for (const CellSide& s : cell) {
    const std::array<lp::LinearProgram::Entry, 3> row{{{0, s.nx}, {1, s.ny}, {2, -std::abs(s.nx) - std::abs(s.ny)}}};
    program.add_row(row, -s.slack / reach);
  }
  const lp::LpSolution solution = lp::interior_point::solve_by_interior_point(program);
  EXPECT_EQ(solution.status, lp::LpStatus::kOptimal);
  return -solution.objective * reach;
}

RC_GTEST_PROP(LargestSquareLaws, NoOtherMethodFindsALargerOne, ()) {
  const auto count = *rc::gen::inRange(0, 60);
  std::vector<CellSide> cell;
  for (int k = 0; k < count; ++k) {
    const double angle = *rc::gen::inRange(0, 360) * 3.141592653589793 / 180;
    const double slack = *rc::gen::inRange(-20, 200);
    cell.push_back({std::cos(angle), std::sin(angle), slack});
  }
  const double reach = 150;
  const Square square = largest_square(cell, reach);
  RC_ASSERT(std::abs(square.half - by_interior_point(cell, reach)) < 1e-4);
  for (const CellSide& s : cell) {
    const double room = s.nx * square.centre.x + s.ny * square.centre.y + s.slack;
    RC_ASSERT(room - (std::abs(s.nx) + std::abs(s.ny)) * square.half > -1e-6);
  }
}

}  // namespace
}  // namespace selvage::motion::piece
