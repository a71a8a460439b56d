// The cache of Minkowski sums: one entry per pair of outlines and relative orientation, and the outlines themselves;
// shared by every marker and every thread, bounded in bytes, counted.  Outlines count as sums do, and stay at least as
// long as their sums.  What it returns does not depend on what it holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/base/executor.h"
#include "core/minkowski/sum.h"
#include "core/outline/outline.h"

namespace selvage::minkowski {

struct CacheCounts {
  std::uint64_t hits{}, misses{};
  std::size_t entries{};  // sums kept
  std::size_t bytes{};    // of them and of the outlines kept
  std::size_t limit{};
};

// The obstacle that piece P is to piece Q, in some frame of its own: a position r = q - p of Q relative to P in the
// marker's frame is to_frame(r) there.
class Obstacle {
 public:
  Obstacle(std::shared_ptr<const MinkowskiSum> sum, Symmetry frame, bool mirrored)
      : sum_{std::move(sum)}, frame_{frame}, into_{frame.inverse()}, mirrored_{mirrored} {}

  [[nodiscard]] const MinkowskiSum& sum() const { return *sum_; }
  [[nodiscard]] Vec to_frame(Vec r) const { return into_.apply(mirrored_ ? -r : r); }
  [[nodiscard]] Vec from_frame(Vec v) const { return mirrored_ ? -frame_.apply(v) : frame_.apply(v); }
  // The same as to_frame, for a direction that need not be on the lattice.
  [[nodiscard]] std::pair<double, double> direction_to_frame(double x, double y) const {
    const Vec unit_x = to_frame({1, 0});
    const Vec unit_y = to_frame({0, 1});
    return {x * static_cast<double>(unit_x.x) + y * static_cast<double>(unit_y.x),
            x * static_cast<double>(unit_x.y) + y * static_cast<double>(unit_y.y)};
  }
  // True when the frame turns left into right.
  [[nodiscard]] bool flips() const { return frame_.flips(); }

 private:
  std::shared_ptr<const MinkowskiSum> sum_;
  Symmetry frame_, into_;
  bool mirrored_;  // the sum is that of P relative to Q: -(P (+) -Q)
};

using OutlinePair =
    std::pair<const outline::OrientedOutline*, const outline::OrientedOutline*>;  // P and Q, neither null

class SumCache {
 public:
  static constexpr std::size_t kDefaultLimit = std::size_t{256} << 20;
  explicit SumCache(std::size_t limit_bytes = kDefaultLimit);
  ~SumCache();
  SumCache(const SumCache&) = delete;
  SumCache& operator=(const SumCache&) = delete;

  // Finds or makes the outline of a polygon.  It is forgotten like a sum.
  [[nodiscard]] std::shared_ptr<const outline::Outline> outline(const Polygon& polygon);

  // Finds or makes the outline of what simplified_outward (core/geometry/outward.h) makes of the polygon: the very same
  // one when that is nothing else.
  [[nodiscard]] std::shared_ptr<const outline::Outline> grown(const std::shared_ptr<const outline::Outline>& outline,
                                                              Coord tolerance);

  // Finds or makes the sum.  The least recently used entries go when the limit is passed; whoever holds one keeps it.
  [[nodiscard]] Obstacle obstacle(const outline::OrientedOutline& p, const outline::OrientedOutline& q);
  // One to each pair.  Sums that are not there yet are made by the crew, each of them once.
  [[nodiscard]] std::vector<Obstacle> obstacles(std::span<const OutlinePair> pairs, const Executor& executor);

  [[nodiscard]] CacheCounts counts() const;

 private:
  struct Store;
  std::unique_ptr<Store> store_;
};

}  // namespace selvage::minkowski

// Vocabulary: named in selvage itself as well, so that every room may use it unqualified.
namespace selvage {
using minkowski::SumCache;
}  // namespace selvage
