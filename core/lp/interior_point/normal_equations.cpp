#include "core/lp/interior_point/normal_equations.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>

#include "core/lp/interior_point/block_cholesky.h"

namespace selvage::lp::interior_point {
namespace {

using Edge = std::pair<int, int>;

// Where a column lies: its block column and its place in it.
struct Seat {
  int block{}, slot{};
};

std::span<const RowRuns::Difference> differences_of(const RowRuns& rows, const RowRuns::Run& run) {
  return std::span{rows.differences}.subspan(static_cast<std::size_t>(run.first_difference),
                                             static_cast<std::size_t>(run.width));
}

// Columns that follow each other and are held by the same rows share a block: those of a piece.  Others have a block to
// themselves, in which the second place stays empty.  The last seat is that of the column that stays still.
std::vector<Seat> seats_of(const RowRuns& rows) {
  const auto size = static_cast<std::size_t>(rows.columns);
  std::vector<char> with_next(size + 1);
  for (const RowRuns::Run& run : rows.runs) {
    const auto of = differences_of(rows, run);
    for (std::size_t k = 0; k + 1 < of.size(); ++k) {
      if (of[k + 1].plus == of[k].plus + 1) with_next[static_cast<std::size_t>(of[k].plus)] = 1;
      if (of[k + 1].minus == of[k].minus + 1) with_next[static_cast<std::size_t>(of[k].minus)] = 1;
    }
  }
  std::vector<Seat> seats(size + 1);
  int block = 0;
  for (std::size_t j = 0; j < size; ++j, ++block) {
    seats[j] = {block, 0};
    if (with_next[j] != 0 && j + 1 < size) seats[++j] = {block, 1};
  }
  seats[size] = {block, 0};
  return seats;
}

// The blocks that have a row in common, the lesser first; neither twice nor with the one that stays still.
std::vector<Edge> edges_of(const RowRuns& rows, const std::vector<Seat>& seats) {
  std::vector<Edge> edges;
  std::vector<int> blocks;
  for (const RowRuns::Run& run : rows.runs) {
    blocks.clear();
    for (const auto& [plus, minus] : differences_of(rows, run)) {
      for (const int column : {plus, minus}) {
        const int block = seats[static_cast<std::size_t>(column)].block;
        if (column != rows.still() && std::find(blocks.begin(), blocks.end(), block) == blocks.end()) {
          blocks.push_back(block);
        }
      }
    }
    for (std::size_t a = 0; a < blocks.size(); ++a) {
      for (std::size_t b = a + 1; b < blocks.size(); ++b) edges.push_back(std::minmax({blocks[a], blocks[b]}));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The place of each block in the order of elimination.
std::vector<int> least_fill(const std::vector<Edge>& edges, int blocks) {
  std::vector<Eigen::Triplet<char>> both;
  both.reserve(2 * edges.size() + static_cast<std::size_t>(blocks));
  for (int k = 0; k < blocks; ++k) both.emplace_back(k, k, 1);
  for (const auto& [a, b] : edges) {
    both.emplace_back(a, b, 1);
    both.emplace_back(b, a, 1);
  }
  Eigen::SparseMatrix<char> pattern(blocks, blocks);
  pattern.setFromTriplets(both.begin(), both.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> first;  // the block at each place
  Eigen::AMDOrdering<int>{}(pattern, first);
  std::vector<int> place(static_cast<std::size_t>(blocks));
  for (int k = 0; k < blocks; ++k) place[static_cast<std::size_t>(first.indices()[k])] = k;
  return place;
}

BlockPattern pattern_of(std::vector<Edge> edges, const std::vector<int>& place) {
  for (auto& [a, b] : edges) {
    const auto [first, second] = std::minmax({place[static_cast<std::size_t>(a)], place[static_cast<std::size_t>(b)]});
    a = second;
    b = first;
  }
  std::sort(edges.begin(), edges.end());
  BlockPattern pattern;
  pattern.start.assign(place.size() + 1, 0);
  for (const auto& [column, row] : edges) {
    ++pattern.start[static_cast<std::size_t>(column) + 1];
    pattern.row.push_back(row);
  }
  for (std::size_t k = 0; k < place.size(); ++k) pattern.start[k + 1] += pattern.start[k];
  return pattern;
}

}  // namespace

struct NormalEquations::Parts {
  explicit Parts(const RowRuns& r) : rows{r} {}
  void find_positions(const BlockPattern& pattern);

  const RowRuns& rows;
  std::vector<Seat> seats;  // in the order of elimination
  std::size_t blocks{};
  // The diagonal blocks, those above, and one for what falls on the column that stays still.
  std::vector<Block> matrix;
  std::vector<int> position;  // in it, number by number, of each run's products; then of each bound's
  std::optional<BlockCholesky> factor;
  std::vector<double> ordered;  // a right side in the order of elimination
};

// Products of two differences fall on four places, those of one with itself on three.
void NormalEquations::Parts::find_positions(const BlockPattern& pattern) {
  const int nowhere = 4 * static_cast<int>(matrix.size() - 1);
  const auto find = [&](int i, int j) {
    if (i == rows.still() || j == rows.still()) return nowhere;
    auto [first, second] = std::pair{seats[static_cast<std::size_t>(i)], seats[static_cast<std::size_t>(j)]};
    if (first.block == second.block) return 4 * first.block + (i == j ? 3 * first.slot : 1);
    if (first.block > second.block) std::swap(first, second);
    const auto begin = pattern.row.begin() + pattern.start[static_cast<std::size_t>(second.block)];
    const auto end = pattern.row.begin() + pattern.start[static_cast<std::size_t>(second.block) + 1];
    const auto above = std::lower_bound(begin, end, first.block) - pattern.row.begin();
    return 4 * static_cast<int>(blocks + static_cast<std::size_t>(above)) + first.slot + 2 * second.slot;
  };
  for (const RowRuns::Run& run : rows.runs) {
    const auto of = differences_of(rows, run);
    for (std::size_t a = 0; a < of.size(); ++a) {
      for (std::size_t b = a; b < of.size(); ++b) {
        position.push_back(find(of[a].plus, of[b].plus));
        position.push_back(find(of[a].minus, of[b].minus));
        position.push_back(find(of[a].plus, of[b].minus));
        if (a != b) position.push_back(find(of[a].minus, of[b].plus));
      }
    }
  }
  for (const RowRuns::Bound& bound : rows.bounds) position.push_back(find(bound.column, bound.column));
}

NormalEquations::NormalEquations(const RowRuns& rows) : parts_{std::make_unique<Parts>(rows)} {
  Parts& p = *parts_;
  p.seats = seats_of(rows);
  const int blocks = p.seats.back().block;
  p.blocks = static_cast<std::size_t>(blocks);
  const std::vector<Edge> edges = edges_of(rows, p.seats);
  const std::vector<int> place = least_fill(edges, blocks);
  for (std::size_t j = 0; j + 1 < p.seats.size(); ++j) {
    p.seats[j].block = place[static_cast<std::size_t>(p.seats[j].block)];
  }
  BlockPattern pattern = pattern_of(edges, place);
  p.matrix.resize(p.blocks + pattern.row.size() + 1);
  p.find_positions(pattern);
  p.factor.emplace(std::move(pattern));
  p.ordered.resize(2 * p.blocks);
}

NormalEquations::~NormalEquations() = default;

bool NormalEquations::factorise(std::span<const double> weight, double rho) {
  Parts& p = *parts_;
  const auto above = p.matrix.begin() + static_cast<std::ptrdiff_t>(p.blocks);
  std::fill(p.matrix.begin(), above, rho * Block::Identity());
  std::fill(above, p.matrix.end(), Block::Zero());
  double* matrix = p.matrix.front().data();
  const int* position = p.position.data();
  for (const RowRuns::Run& run : p.rows.runs) {
    for_weighted_products(p.rows, run, weight, [&](int a, int b, double sum) {
      matrix[*position++] += sum;
      matrix[*position++] += sum;
      matrix[*position++] -= sum;
      if (a != b) matrix[*position++] -= sum;
    });
  }
  const double* w = weight.data() + weight.size() - p.rows.bounds.size();
  for (std::size_t k = 0; k < p.rows.bounds.size(); ++k) matrix[*position++] += w[k];
  return p.factor->factorise({p.matrix.begin(), above}, {above, p.matrix.end() - 1});
}

void NormalEquations::solve(std::span<double> right_side) {
  Parts& p = *parts_;
  std::fill(p.ordered.begin(), p.ordered.end(), 0.0);
  const auto place = [&](std::size_t j) {
    return 2 * static_cast<std::size_t>(p.seats[j].block) + static_cast<std::size_t>(p.seats[j].slot);
  };
  const auto columns = static_cast<std::size_t>(p.rows.columns);
  for (std::size_t j = 0; j < columns; ++j) p.ordered[place(j)] = right_side[j];
  p.factor->solve(p.ordered);
  for (std::size_t j = 0; j < columns; ++j) right_side[j] = p.ordered[place(j)];
}

}  // namespace selvage::lp::interior_point
