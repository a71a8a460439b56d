#include "core/minkowski/sum.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/minkowski/convolution/convex_sum.h"
#include "core/minkowski/ring.h"

namespace selvage::minkowski {
namespace {

// Edges within this many lattice units of another ring's boundary are kept, because rounded end points do not tell on
// which side of it they are.
constexpr double kHidden = 1.0;

Box box_of_edges(std::span<const convolution::SumEdge> edges) {
  Box box{edges.front().from, edges.front().from};
  for (const convolution::SumEdge& e : edges) {
    box.low = {std::min(box.low.x, e.from.x), std::min(box.low.y, e.from.y)};
    box.high = {std::max(box.high.x, e.from.x), std::max(box.high.y, e.from.y)};
  }
  return box;
}

// Removes from each edge the parts that lie inside other rings.
class Visibility {
 public:
  Visibility(std::span<const convolution::StarSum> rings, std::span<const Box> boxes) : sums_{rings}, boxes_{boxes} {
    rings_.reserve(rings.size());
    for (const convolution::StarSum& s : rings) rings_.emplace_back(s);
    // Large rings hide most edges, so they are tested first.
    order_.resize(rings.size());
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    const auto size = [&](std::size_t r) {
      return static_cast<double>(boxes[r].width()) * static_cast<double>(boxes[r].height());
    };
    std::stable_sort(order_.begin(), order_.end(), [&](auto a, auto b) { return size(a) > size(b); });
  }

  std::vector<convolution::SumEdge> visible_edges() {
    std::vector<convolution::SumEdge> visible;
    for (std::size_t r = 0; r < sums_.size(); ++r) {
      for (const convolution::SumEdge& e : sums_[r].edges) {
        if (!e.inner) append_visible(r, e, visible);
      }
    }
    return visible;
  }

 private:
  void append_visible(std::size_t own, const convolution::SumEdge& edge, std::vector<convolution::SumEdge>& visible) {
    const RealVec a = real(edge.from);
    const RealVec b = real(edge.to);
    const Box box = box_of(edge);
    const double least = 2 * kHidden / std::hypot(b.x - a.x, b.y - a.y);  // shorter parts are artefacts of rounding
    shown_ = {{0.0, 1.0}};
    // The ring that hid the previous edge usually hides this one too, since they are neighbours.
    if (last_hider_ != own) hide_behind(last_hider_, own, edge, box, least);
    for (const std::size_t r : order_) {
      if (shown_.empty()) return;
      if (r == own || !boxes_[r].touches(box)) continue;
      hide_behind(r, own, edge, box, least);
      if (shown_.empty()) last_hider_ = r;
    }
    for (const auto& [from, to] : shown_) {
      const auto at = [&](double t) {
        return Vec{std::llround(a.x + t * (b.x - a.x)), std::llround(a.y + t * (b.y - a.y))};
      };
      convolution::SumEdge part = edge;
      if (from > 0) part.from = at(from);
      if (to < 1) part.to = at(to);
      visible.push_back(part);
    }
  }

  // Removes from shown_ the parts of the edge that ring r hides.  Of several edges on one line, only that of the first
  // ring is shown.
  void hide_behind(std::size_t r, std::size_t own, const convolution::SumEdge& edge, const Box& box, double least) {
    if (!boxes_[r].touches(box)) return;
    hidden_.clear();
    rings_[r].append_inside(edge, kHidden, r < own, hidden_);
    for (const auto& [from, to] : hidden_) {
      rest_.clear();
      for (const auto& [low, high] : shown_) {
        if (std::min(high, from) - low >= least) rest_.emplace_back(low, std::min(high, from));
        if (high - std::max(low, to) >= least) rest_.emplace_back(std::max(low, to), high);
      }
      shown_.swap(rest_);
    }
  }

  std::span<const convolution::StarSum> sums_;
  std::span<const Box> boxes_;
  std::vector<Ring> rings_;
  std::size_t last_hider_{};
  std::vector<std::size_t> order_;
  Stretches shown_, hidden_, rest_;
};

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

}  // namespace

MinkowskiSum::MinkowskiSum(std::vector<convolution::StarSum> rings) : rings_{std::move(rings)} {
  ring_boxes_.reserve(rings_.size());
  for (const convolution::StarSum& s : rings_) ring_boxes_.push_back(box_of_edges(s.edges));
  if (rings_.size() > 1) visible_ = Visibility{rings_, ring_boxes_}.visible_edges();
  box_ = ring_boxes_.front();
  for (const Box& b : ring_boxes_) box_ = united(box_, b);
  tree_ = BoxTree{edges()};
}

bool MinkowskiSum::contains(RealVec point) const {
  for (std::size_t r = 0; r < rings_.size(); ++r) {
    const Box& b = ring_boxes_[r];
    if (point.x <= static_cast<double>(b.low.x) || point.x >= static_cast<double>(b.high.x) ||
        point.y <= static_cast<double>(b.low.y) || point.y >= static_cast<double>(b.high.y)) {
      continue;
    }
    if (holds(rings_[r], point, kHidden)) return true;
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
  const Operand p{first};
  const Operand q{second};
  const bool merging = p.all_convex() && q.all_convex();
  const std::vector<convolution::Turns> of_p = merging ? std::vector<convolution::Turns>{} : p.turns();
  const std::vector<convolution::Turns> of_q = merging ? std::vector<convolution::Turns>{} : q.turns();
  std::vector<convolution::StarSum> rings;
  rings.reserve(first.size() * second.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    for (std::size_t j = 0; j < second.size(); ++j) {
      rings.push_back(p.convex[i] && q.convex[j] ? convolution::convex_sum(first[i], second[j])
                                                 : convolution::star_sum({first[i], of_p[i]}, {second[j], of_q[j]}));
    }
  }
  return MinkowskiSum{std::move(rings)};
}

MinkowskiSum obstacle_sum(const outline::Outline& p, const outline::Outline& q, Symmetry relative) {
  const Symmetry mirrored = Symmetry{false, 2}.after(relative);
  std::vector<outline::StarPart> moved;
  moved.reserve(q.parts.size());
  for (const outline::StarPart& part : q.parts) moved.push_back(transformed(part, mirrored));
  return minkowski_sum(p.parts, moved);
}

}  // namespace selvage::minkowski
