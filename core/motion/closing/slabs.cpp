#include "core/motion/closing/slabs.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace selvage::motion::closing {

Slabs::Slabs(const marker::PlacedPieces& pieces, Coord width)
    : spacing_{pieces.widest_spacing()}, height_{std::max<Coord>(1, width / static_cast<Coord>(kSlabs))} {
  for (std::uint32_t k = 0; k < pieces.size(); ++k) {
    const auto [first, last] = range(pieces.box(k));
    for (std::size_t slab = first; slab <= last; ++slab) add(slab, k, pieces[k]);
  }
  for (std::vector<Span>& spans : spans_) std::sort(spans.begin(), spans.end());
}

Coord Slabs::free_distance(const std::vector<bool>& moving, const Box& box) const {
  Coord least = std::numeric_limits<Coord>::max();
  const auto [first, last] = range(box);
  for (std::size_t slab = first; slab <= last; ++slab) {
    Coord end = -kLatticeLimit;  // of the other pieces so far
    for (const Span& span : spans_[slab]) {
      if (moving[span.piece]) {
        least = std::min(least, span.from - end - spacing_);
      } else {
        end = std::max(end, span.to);
      }
    }
  }
  return least;
}

void Slabs::move(const std::vector<bool>& moving, const Box& box, Coord by) {
  const auto [first, last] = range(box);
  for (std::size_t slab = first; slab <= last; ++slab) {
    for (Span& span : spans_[slab]) {
      if (!moving[span.piece]) continue;
      span.from -= by;
      span.to -= by;
    }
  }
}

std::pair<std::size_t, std::size_t> Slabs::range(const Box& box) const {
  const auto slab = [this](Coord y) {
    return static_cast<std::size_t>(std::clamp<Coord>(y / height_, 0, static_cast<Coord>(kSlabs) - 1));
  };
  return {slab(box.low.y - spacing_), slab(box.high.y + spacing_)};
}

void Slabs::add(std::size_t slab, std::uint32_t piece, const geometry::PlacedPolygon& polygon) {
  const auto number = static_cast<Coord>(slab);
  // The first and the last slab also have what lies beyond the strip.
  const Coord low = slab == 0 ? -kLatticeLimit : number * height_ - spacing_;
  const Coord high = slab == kSlabs - 1 ? kLatticeLimit : (number + 1) * height_ + spacing_;
  Span span{kLatticeLimit, -kLatticeLimit, piece};
  const auto reach = [&span](double x) {
    span.from = std::min(span.from, static_cast<Coord>(std::floor(x)) - 1);
    span.to = std::max(span.to, static_cast<Coord>(std::ceil(x)) + 1);
  };
  const std::size_t vertices = polygon.vertices.size();
  for (std::size_t k = 0; k < vertices; ++k) {
    Vec a = polygon.vertices[k] + polygon.at;
    Vec b = polygon.vertices[k + 1 == vertices ? 0 : k + 1] + polygon.at;
    if (a.y > b.y) std::swap(a, b);
    if (b.y < low || a.y > high) continue;
    const auto x_at = [&](Coord y) {
      const double part = static_cast<double>(y - a.y) / static_cast<double>(b.y - a.y);
      return static_cast<double>(a.x) + part * static_cast<double>(b.x - a.x);
    };
    reach(a.y < low ? x_at(low) : static_cast<double>(a.x));
    reach(b.y > high ? x_at(high) : static_cast<double>(b.x));
  }
  if (span.from <= span.to) spans_[slab].push_back(span);
}

}  // namespace selvage::motion::closing
