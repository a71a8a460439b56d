#include "core/minkowski/rings/visible_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <utility>

#include "core/minkowski/rings/boxes_by_area.h"
#include "core/minkowski/rings/ring.h"

namespace selvage::minkowski::rings {
namespace {

// Among up to kFew rings, all are tested, largest first.  Among more, the kLarge largest ones are; where these do not
// suffice, the kTried smallest rings around the present one are tried, and then all near it.
constexpr std::size_t kFew = 128;
constexpr std::size_t kLarge = 8;
constexpr std::size_t kTried = 4;

// True when both rings consist of the same edges.
bool repeats(const convolution::StarSum& a, const convolution::StarSum& b) {
  return std::ranges::equal(a.edges, b.edges, [](const convolution::SumEdge& e, const convolution::SumEdge& f) {
    return e.from == f.from && e.to == f.to && e.line_from == f.line_from && e.line_to == f.line_to &&
           e.inner == f.inner;
  });
}

// Removes from each edge the parts that lie inside other rings.  Large rings hide most edges, so they are tested first.
class Visibility {
 public:
  Visibility(std::span<const convolution::StarSum> rings, std::span<const Box> boxes)
      : sums_{rings}, boxes_{boxes}, order_{by_area(boxes)}, rank_(rings.size()) {
    rings_.reserve(rings.size());
    for (const convolution::StarSum& s : rings) rings_.emplace_back(s);
    for (std::uint32_t place = 0; place < order_.size(); ++place) rank_[order_[place]] = place;
    const std::size_t large = order_.size() > kFew ? kLarge : order_.size();
    large_.assign(order_.begin(), order_.begin() + static_cast<std::ptrdiff_t>(large));
    if (large < order_.size()) others_.emplace(boxes, rank_);
  }

  // Nothing when stopped.
  std::optional<std::vector<convolution::SumEdge>> edges(const std::function<bool()>& stopped) {
    std::vector<convolution::SumEdge> all;
    std::vector<std::pair<std::size_t, std::size_t>> part_of(sums_.size());  // of each ring in `all`
    for (const std::uint32_t r : order_) {
      if (stopped && stopped()) return {};
      const std::size_t first = all.size();
      append_visible(r, all);
      part_of[r] = {first, all.size()};
    }
    std::vector<convolution::SumEdge> by_ring;
    by_ring.reserve(all.size());
    const auto edges_at = [&](std::size_t k) { return all.begin() + static_cast<std::ptrdiff_t>(k); };
    for (const auto& [first, end] : part_of) by_ring.insert(by_ring.end(), edges_at(first), edges_at(end));
    return by_ring;
  }

 private:
  // Appends the visible parts of a ring's edges.
  void append_visible(std::uint32_t own, std::vector<convolution::SumEdge>& visible) {
    looked_around_ = false;
    for (const convolution::SumEdge& e : sums_[own].edges) {
      if (e.inner) continue;
      find_shown(own, e);
      if (shown_.empty()) continue;
      // Before each edge is compared with all rings near it, see whether one of these hides the whole ring.
      if (others_ && !std::exchange(looked_around_, true) && lies_within_another(own)) return;
      if (others_) hide_behind_others(own, e);
      append_shown(e, visible);
    }
  }

  // True when a single ring hides the present one.  What the present one hides is then hidden by the other one too, so
  // it is left out.
  bool lies_within_another(std::uint32_t own) {
    others_->search_containing(boxes_[own]);
    for (std::size_t tries = 0; tries < kTried; ++tries) {
      const auto r = others_->next();
      if (!r) return false;
      if (*r == own || !lies_within(own, *r)) continue;
      std::erase(large_, own);
      others_->leave_out(own);
      return true;
    }
    return false;
  }

  // True when ring `by` hides all edges of the present ring, those inside the whole sum included.
  bool lies_within(std::uint32_t own, std::uint32_t by) {
    const Stretches kept = std::exchange(shown_, {});
    const bool within = std::ranges::all_of(sums_[own].edges, [&](const convolution::SumEdge& e) {
      shown_ = {{0.0, 1.0}};
      hide_behind(by, own, e);
      return shown_.empty();
    });
    shown_ = kept;
    return within;
  }

  // Finds the parts of the edge that the largest rings do not hide.
  void find_shown(std::uint32_t own, const convolution::SumEdge& edge) {
    const Box box = box_of(edge);
    shown_ = {{0.0, 1.0}};
    // The ring that hid the previous edge usually hides this one too, since they are neighbours.
    if (last_hider_ != own && boxes_[last_hider_].touches(box)) hide_behind(last_hider_, own, edge);
    for (std::size_t k = 0; !shown_.empty() && k < large_.size(); ++k) {
      const std::uint32_t r = large_[k];
      if (r == own || !boxes_[r].touches(box)) continue;
      hide_behind(r, own, edge);
      if (shown_.empty()) last_hider_ = r;
    }
  }

  // Removes from shown_ what the rings near the edge hide, the largest ones excepted, which find_shown has tested.
  void hide_behind_others(std::uint32_t own, const convolution::SumEdge& edge) {
    others_->search_touching(box_of(edge));
    while (!shown_.empty()) {
      const auto r = others_->next();
      if (!r) return;
      if (*r == own || rank_[*r] < kLarge) continue;
      hide_behind(*r, own, edge);
      if (shown_.empty()) last_hider_ = *r;
    }
  }

  void append_shown(const convolution::SumEdge& edge, std::vector<convolution::SumEdge>& visible) const {
    const RealVec a = real(edge.from);
    const RealVec b = real(edge.to);
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

  // Removes from shown_ the parts of the edge that ring r hides.  Of several edges on one line, only that of the
  // largest ring is shown.
  void hide_behind(std::uint32_t r, std::uint32_t own, const convolution::SumEdge& edge) {
    const RealVec along = real(edge.to - edge.from);
    const double least = 2 * kHidden / std::hypot(along.x, along.y);  // shorter parts are artefacts of rounding
    hidden_.clear();
    rings_[r].append_inside(edge, kHidden, rank_[r] < rank_[own], hidden_);
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
  std::vector<std::uint32_t> order_;  // the rings by the area of their boxes, the largest first
  std::vector<std::uint32_t> rank_;   // of each ring in that order
  std::vector<Ring> rings_;
  std::vector<std::uint32_t> large_;  // the rings that are tested whether or not they are near
  std::optional<BoxesByArea> others_;
  bool looked_around_{};  // for a ring that hides the whole of the present one
  std::uint32_t last_hider_{};
  Stretches shown_, hidden_, rest_;
};

}  // namespace

void leave_out_repeats(std::vector<convolution::StarSum>& rings) {
  if (rings.size() <= kFew) return;
  std::unordered_multimap<std::size_t, std::size_t> seen;  // by hash
  std::size_t kept = 0;
  for (std::size_t r = 0; r < rings.size(); ++r) {
    std::size_t hash = rings[r].edges.size();
    for (const convolution::SumEdge& e : rings[r].edges) {
      hash = (hash ^ static_cast<std::size_t>(e.from.x)) * 0x9e3779b97f4a7c15U;
      hash = (hash ^ static_cast<std::size_t>(e.from.y)) * 0x9e3779b97f4a7c15U;
    }
    const auto [first, last] = seen.equal_range(hash);
    if (std::any_of(first, last, [&](const auto& one) { return repeats(rings[one.second], rings[r]); })) continue;
    if (kept != r) rings[kept] = std::move(rings[r]);
    seen.emplace(hash, kept++);
  }
  rings.resize(kept);
}

std::optional<std::vector<convolution::SumEdge>> visible_edges(std::span<const convolution::StarSum> rings,
                                                               std::span<const Box> boxes,
                                                               const std::function<bool()>& stopped) {
  return Visibility{rings, boxes}.edges(stopped);
}

}  // namespace selvage::minkowski::rings
