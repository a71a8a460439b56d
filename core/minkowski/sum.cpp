#include "core/minkowski/sum.h"

#include <algorithm>
#include <utility>

#include "core/minkowski/convolution/convex_sum.h"
#include "core/minkowski/rings/ring.h"
#include "core/minkowski/rings/visible_edges.h"

namespace selvage::minkowski {
namespace {

Box box_of_edges(std::span<const convolution::SumEdge> edges) {
  Box box{edges.front().from, edges.front().from};
  for (const convolution::SumEdge& e : edges) {
    box.low = {std::min(box.low.x, e.from.x), std::min(box.low.y, e.from.y)};
    box.high = {std::max(box.high.x, e.from.x), std::max(box.high.y, e.from.y)};
  }
  return box;
}

// The parts of one outline, and which of them are convex.
struct Operand {
  explicit Operand(std::span<const outline::StarPart> of) : parts{of} {
    for (const outline::StarPart& part : parts) convex.push_back(is_convex(part.vertices));
  }
  [[nodiscard]] bool all_convex() const {
    return std::all_of(convex.begin(), convex.end(), [](bool one) { return one; });
  }
  [[nodiscard]] std::vector<convolution::Turns> turns() const {
    std::vector<convolution::Turns> turns;
    turns.reserve(parts.size());
    for (const outline::StarPart& part : parts) turns.emplace_back(part.vertices);
    return turns;
  }

  std::span<const outline::StarPart> parts;
  std::vector<bool> convex;
};

// The sums of all pairs of parts; none when stopped.
std::vector<convolution::StarSum> star_sums(std::span<const outline::StarPart> first,
                                            std::span<const outline::StarPart> second,
                                            const std::function<bool()>& stopped) {
  const Operand p{first};
  const Operand q{second};
  const bool merging = p.all_convex() && q.all_convex();
  const std::vector<convolution::Turns> of_p = merging ? std::vector<convolution::Turns>{} : p.turns();
  const std::vector<convolution::Turns> of_q = merging ? std::vector<convolution::Turns>{} : q.turns();
  std::vector<convolution::StarSum> rings;
  rings.reserve(first.size() * second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      if (stopped && stopped()) return {};
      if (p.convex[i] && q.convex[j]) {
        rings.push_back(convolution::convex_sum(first[i], second[j]));
        continue;
      }
      auto ring = convolution::star_sum({first[i], of_p[i]}, {second[j], of_q[j]}, stopped);
      if (!ring) return {};
      rings.push_back(*std::move(ring));
    }
  }
  return rings;
}

}  // namespace

MinkowskiSum::MinkowskiSum(std::vector<convolution::StarSum> rings) : MinkowskiSum{*united(std::move(rings), {})} {}

std::optional<MinkowskiSum> MinkowskiSum::united(std::vector<convolution::StarSum> rings,
                                                 const std::function<bool()>& stopped) {
  rings::leave_out_repeats(rings);
  MinkowskiSum sum;
  sum.ring_boxes_.reserve(rings.size());
  for (const convolution::StarSum& s : rings) sum.ring_boxes_.push_back(box_of_edges(s.edges));
  if (rings.size() > 1) {
    auto visible = rings::visible_edges(rings, sum.ring_boxes_, stopped);
    if (!visible) return {};
    sum.visible_ = *std::move(visible);
  }
  sum.rings_ = std::move(rings);
  sum.box_ = sum.ring_boxes_.front();
  for (const Box& b : sum.ring_boxes_) sum.box_ = geometry::united(sum.box_, b);
  sum.tree_ = rings::BoxTree{sum.edges()};
  return sum;
}

bool MinkowskiSum::contains(RealVec point) const {
  for (std::size_t r = 0; r < rings_.size(); ++r) {
    const Box& b = ring_boxes_[r];
    if (point.x <= static_cast<double>(b.low.x) || point.x >= static_cast<double>(b.high.x) ||
        point.y <= static_cast<double>(b.low.y) || point.y >= static_cast<double>(b.high.y)) {
      continue;
    }
    if (rings::holds(rings_[r], point, rings::kHidden)) return true;
  }
  return false;
}

std::size_t MinkowskiSum::bytes() const {
  std::size_t total = sizeof *this + visible_.capacity() * sizeof(convolution::SumEdge) +
                      ring_boxes_.capacity() * sizeof(Box) + tree_.bytes();
  for (const convolution::StarSum& s : rings_) total += sizeof s + s.edges.capacity() * sizeof(convolution::SumEdge);
  return total;
}

MinkowskiSum minkowski_sum(std::span<const outline::StarPart> first, std::span<const outline::StarPart> second) {
  return MinkowskiSum{star_sums(first, second, {})};
}

MinkowskiSum obstacle_sum(const outline::Outline& p, const outline::Outline& q, Symmetry relative) {
  return *obstacle_sum(p, q, relative, {});
}

std::optional<MinkowskiSum> obstacle_sum(const outline::Outline& p, const outline::Outline& q, Symmetry relative,
                                         const std::function<bool()>& stopped) {
  const Symmetry mirrored = Symmetry{false, 2}.after(relative);
  std::vector<outline::StarPart> moved;
  moved.reserve(q.parts.size());
  for (const outline::StarPart& part : q.parts) moved.push_back(transformed(part, mirrored));
  std::vector<convolution::StarSum> rings = star_sums(p.parts, moved, stopped);
  if (rings.empty()) return {};
  return MinkowskiSum::united(std::move(rings), stopped);
}

}  // namespace selvage::minkowski
