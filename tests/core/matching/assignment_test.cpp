#include "core/matching/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

#include "tests/support/random.h"

namespace selvage::matching {
namespace {

Costs random_costs(test::Random& random, std::size_t rows, std::size_t columns, Coord most) {
  Costs costs{rows, columns};
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      costs(row, column) = static_cast<double>(random.between(-most, most)) / 16;
    }
  }
  return costs;
}

// The least cost by trying every permutation of the longer side.
double by_brute_force(const Costs& costs) {
  const bool wide = costs.rows() <= costs.columns();
  std::vector<std::size_t> order(std::max(costs.rows(), costs.columns()));
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    double cost = 0;
    for (std::size_t k = 0; k < std::min(costs.rows(), costs.columns()); ++k) {
      cost += wide ? costs(k, order[k]) : costs(order[k], k);
    }
    least = std::min(least, cost);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

// The least cost by cancelling negative cycles [the textbook method for flows]: starts from any assignment of the
// square matrix and improves it along negative cycles, found by Bellman and Ford's method, until there are none.
double by_cycles(const Costs& costs) {
  const std::size_t size = std::max(costs.rows(), costs.columns());
  const auto at = [&](std::size_t row, std::size_t column) {
    return row < costs.rows() && column < costs.columns() ? costs(row, column) : 0.0;
  };
  std::vector<std::size_t> column_of(size);
  std::iota(column_of.begin(), column_of.end(), std::size_t{0});
  while (true) {
    // An edge from row i to row j: i takes the column of j.
    std::vector<double> distance(size);
    std::vector<std::size_t> before(size, size);
    std::size_t changed = size;
    for (std::size_t pass = 0; pass <= size; ++pass) {
      changed = size;
      for (std::size_t i = 0; i < size; ++i) {
        for (std::size_t j = 0; j < size; ++j) {
          const double reached = distance[i] + at(i, column_of[j]) - at(i, column_of[i]);
          if (reached >= distance[j] - 1e-9) continue;
          distance[j] = reached;
          before[j] = i;
          changed = j;
        }
      }
    }
    if (changed == size) break;
    std::size_t on_cycle = changed;
    for (std::size_t k = 0; k < size; ++k) on_cycle = before[on_cycle];
    const std::vector<std::size_t> old = column_of;
    std::size_t row = on_cycle;
    do {
      column_of[before[row]] = old[row];
      row = before[row];
    } while (row != on_cycle);
  }
  double cost = 0;
  for (std::size_t row = 0; row < size; ++row) cost += at(row, column_of[row]);
  return cost;
}

// Law 1: complementary slackness proves that the assignment is optimal.
void expect_proved(const Costs& costs, const Assignment& assignment) {
  constexpr double kRounding = 1e-7;
  std::vector<bool> taken(costs.columns());
  std::size_t assigned = 0;
  double cost = 0;
  for (std::size_t row = 0; row < costs.rows(); ++row) {
    for (std::size_t column = 0; column < costs.columns(); ++column) {
      EXPECT_GE(costs(row, column), assignment.row_prices[row] + assignment.column_prices[column] - kRounding);
    }
    const auto column = assignment.column_of[row];
    if (!column) {
      EXPECT_EQ(assignment.row_prices[row], 0);
      continue;
    }
    EXPECT_FALSE(taken[*column]);
    taken[*column] = true;
    ++assigned;
    cost += costs(row, *column);
    EXPECT_NEAR(costs(row, *column), assignment.row_prices[row] + assignment.column_prices[*column], kRounding);
  }
  EXPECT_EQ(assigned, std::min(costs.rows(), costs.columns()));
  EXPECT_NEAR(cost, assignment.cost, kRounding);
  for (std::size_t column = 0; column < costs.columns(); ++column) {
    if (!taken[column]) {
      EXPECT_EQ(assignment.column_prices[column], 0);
    }
  }
}

TEST(Assignment, AgreesWithBruteForce) {
  test::Random random{1};
  for (int trial = 0; trial < 300 / test::kSlowdown; ++trial) {
    const std::size_t rows = 1 + random.below(7);
    const Costs costs = random_costs(random, rows, 1 + random.below(7), trial % 2 == 0 ? 1000 : 3);
    const Assignment assignment = assign(costs);
    expect_proved(costs, assignment);
    EXPECT_NEAR(assignment.cost, by_brute_force(costs), 1e-9);
  }
}

TEST(Assignment, AgreesWithCancellingOfCycles) {
  test::Random random{2};
  for (int trial = 0; trial < 12 / test::kSlowdown + 1; ++trial) {
    const Costs costs = random_costs(random, 5 + random.below(36), 5 + random.below(36), trial % 2 == 0 ? 1000 : 5);
    const Assignment assignment = assign(costs);
    expect_proved(costs, assignment);
    EXPECT_NEAR(assignment.cost, by_cycles(costs), 1e-6);
  }
}

TEST(Assignment, ProvesItsAnswerForManyRows) {
  test::Random random{3};
  const Costs costs = random_costs(random, 120, 130, 100'000);
  expect_proved(costs, assign(costs));
}

TEST(Assignment, OfNothingIsEmpty) {
  const Assignment none = assign(Costs{0, 0});
  EXPECT_TRUE(none.column_of.empty());
  const Assignment rows = assign(Costs{3, 0});
  ASSERT_EQ(rows.column_of.size(), 3U);
  EXPECT_FALSE(rows.column_of[0]);
  EXPECT_EQ(assign(Costs{0, 2}).cost, 0);
}

TEST(Assignment, IsEmptyWhenCancelled) {
  std::stop_source stop;
  stop.request_stop();
  for (const auto& [rows, columns] : {std::pair{4U, 5U}, {5U, 4U}}) {
    const Assignment assignment = assign(Costs{rows, columns}, stop.get_token());
    EXPECT_EQ(assignment.column_of, std::vector<std::optional<std::size_t>>(rows));
    EXPECT_EQ(assignment.cost, 0);
  }
}

TEST(Assignment, PrefersTheFirstOfEqualColumns) {
  const Assignment assignment = assign(Costs{2, 4});
  EXPECT_EQ(assignment.column_of[0], 0U);
  EXPECT_EQ(assignment.column_of[1], 1U);
}

}  // namespace
}  // namespace selvage::matching
