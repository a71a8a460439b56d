#include "core/lp/interior_point/border.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/lp/elimination/elimination_order.h"

namespace selvage::lp::interior_point {
namespace {

// Each column's place when consecutive columns of the program, such as those of a piece, share a block.
std::vector<std::size_t> paired_places(std::span<const int> columns) {
  std::vector<std::size_t> place(columns.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < columns.size(); ++k, next += 2) {
    place[k] = next;
    if (k + 1 < columns.size() && columns[k + 1] == columns[k] + 1) place[++k] = next + 1;
  }
  return place;
}

// An entry of the matrix that remains of a member.
struct Remainder {
  const double* from{};
  std::size_t i{}, j{};  // columns of the border
};
std::vector<Remainder> remainders(std::span<const Border::Member> members) {
  std::vector<Remainder> all;
  for (const Border::Member& member : members) {
    for (std::size_t a = 0; a < member.border.size(); ++a) {
      for (std::size_t b = 0; b <= a; ++b) {
        const double* from =
            member.normal->remaining(member.own + static_cast<int>(a), member.own + static_cast<int>(b));
        if (from == nullptr) continue;
        all.push_back({from, static_cast<std::size_t>(member.border[a]), static_cast<std::size_t>(member.border[b])});
      }
    }
  }
  return all;
}

}  // namespace

Border::Border(std::span<const int> columns, std::span<const Member> members)
    : place_{paired_places(columns)},
      blocks_{place_.empty() ? 0 : place_.back() / 2 + 1},
      factor_{elimination::BlockPattern{}} {
  const std::vector<Remainder> all = remainders(members);
  std::vector<elimination::Edge> edges;
  for (const auto& [from, i, j] : all) {
    const auto [first, second] = std::minmax({static_cast<int>(place_[i] / 2), static_cast<int>(place_[j] / 2)});
    if (first != second) edges.emplace_back(first, second);
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const auto count = static_cast<int>(blocks_);
  const std::vector<int> order = elimination::elimination_order(edges, count, count);
  for (std::size_t& place : place_) place = 2 * static_cast<std::size_t>(order[place / 2]) + place % 2;
  elimination::BlockPattern pattern = elimination::pattern_of(std::move(edges), order);
  for (const auto& [from, i, j] : all) {
    const auto [first, second] = std::minmax(place_[i], place_[j]);
    std::size_t block = first / 2;
    // In a block on the diagonal the lower triangle counts, in one above it the row is the earlier column's.
    std::size_t within = second % 2 + 2 * (first % 2);
    if (first / 2 != second / 2) {
      const auto begin = pattern.row.begin() + pattern.start[second / 2];
      const auto end = pattern.row.begin() + pattern.start[second / 2 + 1];
      const auto above = std::lower_bound(begin, end, static_cast<int>(first / 2)) - pattern.row.begin();
      block = blocks_ + static_cast<std::size_t>(above);
      within = first % 2 + 2 * (second % 2);
    }
    transfers_.push_back({from, 4 * block + within});
  }
  matrix_.resize(blocks_ + pattern.row.size());
  factor_ = elimination::BlockCholesky{std::move(pattern)};
  ordered_.resize(2 * blocks_);
}

bool Border::factorise(double rho, const std::stop_token& stop) {
  if (blocks_ == 0) return true;
  const auto above = matrix_.begin() + static_cast<std::ptrdiff_t>(blocks_);
  std::fill(matrix_.begin(), above, rho * elimination::Block::Identity());
  std::fill(above, matrix_.end(), elimination::Block::Zero());
  double* const matrix = matrix_.front().data();
  for (const auto& [from, to] : transfers_) matrix[to] += *from;
  return factor_.factorise({matrix_.begin(), above}, {above, matrix_.end()}, stop);
}

void Border::solve(std::span<double> right_side) {
  std::fill(ordered_.begin(), ordered_.end(), 0.0);
  for (std::size_t k = 0; k < place_.size(); ++k) ordered_[place_[k]] = right_side[k];
  factor_.solve(ordered_);
  for (std::size_t k = 0; k < place_.size(); ++k) right_side[k] = ordered_[place_[k]];
}

}  // namespace selvage::lp::interior_point
