#include "core/minkowski/rings/boxes_by_area.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace selvage::minkowski::rings {
namespace {

std::vector<std::uint32_t> numbered(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::uint32_t{0});
  return numbers;
}

// The boxes in the order of the leaves.
std::vector<std::uint32_t> packed(std::span<const Box> boxes) {
  std::vector<std::uint32_t> order = numbered(boxes.size());
  const auto sort = [&](auto first, auto last, auto middle) {
    std::sort(first, last, [&](std::uint32_t a, std::uint32_t b) {
      return std::pair{middle(boxes[a]), a} < std::pair{middle(boxes[b]), b};
    });
  };
  sort(order.begin(), order.end(), [](const Box& box) { return box.low.x + box.high.x; });
  const auto slice =
      static_cast<std::ptrdiff_t>(std::ceil(std::sqrt(static_cast<double>(boxes.size() * BoxTree::kFan))));
  for (auto first = order.begin(); first != order.end();) {
    const auto last = first + std::min(slice, order.end() - first);
    sort(first, last, [](const Box& box) { return box.low.y + box.high.y; });
    first = last;
  }
  return order;
}

BoxTree tree_of(std::span<const Box> boxes, std::span<const std::uint32_t> order) {
  std::vector<Box> leaves;
  leaves.reserve(order.size());
  for (const std::uint32_t k : order) leaves.push_back(boxes[k]);
  return BoxTree{leaves};
}

}  // namespace

std::vector<std::uint32_t> by_area(std::span<const Box> boxes) {
  std::vector<std::uint32_t> order = numbered(boxes.size());
  const auto area = [&](std::uint32_t k) {
    return static_cast<double>(boxes[k].width()) * static_cast<double>(boxes[k].height());
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return area(a) > area(b); });
  return order;
}

BoxesByArea::BoxesByArea(std::span<const Box> boxes, std::span<const std::uint32_t> rank)
    : boxes_{boxes}, leaf_{packed(boxes)}, leaf_of_(boxes.size()), tree_{tree_of(boxes, leaf_)} {
  ranks_.resize(tree_.levels() + 1);
  for (std::uint32_t leaf = 0; leaf < leaf_.size(); ++leaf) {
    leaf_of_[leaf_[leaf]] = leaf;
    ranks_[0].push_back({rank[leaf_[leaf]], rank[leaf_[leaf]]});
  }
  for (std::size_t level = 1; level < ranks_.size(); ++level) {
    const std::size_t below = ranks_[level - 1].size();
    for (std::size_t k = 0; k * BoxTree::kFan < below; ++k) ranks_[level].push_back(ranks_below(level, k));
  }
}

BoxesByArea::Ranks BoxesByArea::ranks_below(std::size_t level, std::size_t index) const {
  Ranks all{std::numeric_limits<std::int64_t>::max(), -1};
  for (std::size_t k = index * BoxTree::kFan; k < tree_.end_of_run(level - 1, index); ++k) {
    const Ranks& one = ranks_[level - 1][k];
    all = {std::min(all.least, one.least), std::max(all.most, one.most)};
  }
  return all;
}

void BoxesByArea::leave_out(std::uint32_t box) {
  std::size_t index = leaf_of_[box];
  ranks_[0][index] = {std::numeric_limits<std::int64_t>::max(), -1};
  for (std::size_t level = 1; level < ranks_.size(); ++level) {
    index /= BoxTree::kFan;
    ranks_[level][index] = ranks_below(level, index);
  }
}

void BoxesByArea::search_touching(const Box& window) {
  search(window, false);
}

void BoxesByArea::search_containing(const Box& window) {
  search(window, true);
}

void BoxesByArea::search(const Box& window, bool containing) {
  window_ = window;
  containing_ = containing;
  open_.clear();
  if (!leaf_.empty()) push(tree_.levels(), 0);
}

void BoxesByArea::push(std::size_t level, std::size_t index) {
  const Ranks& ranks = ranks_[level][index];
  const Box& bounds = box(level, index);
  if (ranks.least > ranks.most || !(containing_ ? bounds.contains(window_) : bounds.touches(window_))) return;
  open_.push_back(
      {containing_ ? ranks.most : -ranks.least, static_cast<std::uint32_t>(level), static_cast<std::uint32_t>(index)});
  std::push_heap(open_.begin(), open_.end());
}

std::optional<std::uint32_t> BoxesByArea::next() {
  while (!open_.empty()) {
    std::pop_heap(open_.begin(), open_.end());
    const Node node = open_.back();
    open_.pop_back();
    if (node.level == 0) return leaf_[node.index];
    const std::size_t end = tree_.end_of_run(node.level - 1, node.index);
    for (std::size_t k = node.index * BoxTree::kFan; k < end; ++k) push(node.level - 1, k);
  }
  return {};
}

}  // namespace selvage::minkowski::rings
