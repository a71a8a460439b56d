// The cache of Minkowski sums: one entry per pair of outlines and relative orientation, and the outlines themselves.
//
// The cache is shared by all markers and threads (it is thread-safe), limited in bytes, and counts its hits and misses.
// Outlines count towards the limit as sums do, and are kept at least as long as their sums.
// Invariant: results do not depend on what the cache contains.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <utility>
#include <vector>

#include "core/base/executor.h"
#include "core/minkowski/sum.h"
#include "core/outline/outline.h"

namespace selvage::minkowski {

struct CacheCounts {
  std::uint64_t hits{}, misses{};
  std::size_t entries{};  // number of sums in the cache
  std::size_t bytes{};    // size of the cached sums and outlines
  std::size_t limit{};
};

// The obstacle that piece P presents to piece Q, in a frame of its own: to_frame maps a position r = q - p of Q
// relative to P from the marker's frame to the obstacle's.
class Obstacle {
 public:
  Obstacle(std::shared_ptr<const MinkowskiSum> sum, Symmetry frame, bool mirrored)
      : sum_{std::move(sum)}, frame_{frame}, into_{frame.inverse()}, mirrored_{mirrored} {}

  [[nodiscard]] const MinkowskiSum& sum() const { return *sum_; }
  [[nodiscard]] Vec to_frame(Vec r) const { return into_.apply(mirrored_ ? -r : r); }
  [[nodiscard]] Vec from_frame(Vec v) const { return mirrored_ ? -frame_.apply(v) : frame_.apply(v); }
  // The same as to_frame for a direction with real coordinates.
  [[nodiscard]] std::pair<double, double> direction_to_frame(double x, double y) const {
    const Vec unit_x = to_frame({1, 0});
    const Vec unit_y = to_frame({0, 1});
    return {x * static_cast<double>(unit_x.x) + y * static_cast<double>(unit_y.x),
            x * static_cast<double>(unit_x.y) + y * static_cast<double>(unit_y.y)};
  }
  // True when the frame is mirrored.
  [[nodiscard]] bool flips() const { return frame_.flips(); }

 private:
  std::shared_ptr<const MinkowskiSum> sum_;
  Symmetry frame_, into_;
  bool mirrored_;  // the stored sum is that of P relative to Q: -(P (+) -Q)
};

using OutlinePair =
    std::pair<const outline::OrientedOutline*, const outline::OrientedOutline*>;  // P and Q; neither is null

class SumCache {
 public:
  static constexpr std::size_t kDefaultLimit = std::size_t{256} << 20;
  explicit SumCache(std::size_t limit_bytes = kDefaultLimit);
  ~SumCache();
  SumCache(const SumCache&) = delete;
  SumCache& operator=(const SumCache&) = delete;

  // Returns the outline of a polygon, computing it if necessary.  Outlines are evicted like sums.
  [[nodiscard]] std::shared_ptr<const outline::Outline> outline(const Polygon& polygon);

  // Returns the outline of the result of simplified_outward (core/outline/outward.h), computing it if necessary.
  // Returns `outline` itself when nothing can be simplified.
  [[nodiscard]] std::shared_ptr<const outline::Outline> grown(const std::shared_ptr<const outline::Outline>& outline,
                                                              Coord tolerance);

  // Returns the obstacle of a pair, computing its sum if necessary.  The least recently used entries are evicted when
  // the limit is exceeded; an obstacle shares ownership of its sum, so it stays usable.
  [[nodiscard]] Obstacle obstacle(const outline::OrientedOutline& p, const outline::OrientedOutline& q);
  // The same; nothing when cancelled while its sum is computed.
  [[nodiscard]] std::optional<Obstacle> obstacle(const outline::OrientedOutline& p, const outline::OrientedOutline& q,
                                                 const std::stop_token& stop);
  // Returns one obstacle per pair.  Missing sums are computed in parallel by the executor, each exactly once.  When
  // cancelled, it returns none and finishes no further sum.
  [[nodiscard]] std::vector<Obstacle> obstacles(std::span<const OutlinePair> pairs, const Executor& executor,
                                                const std::stop_token& stop = {});

  [[nodiscard]] CacheCounts counts() const;

 private:
  struct Store;
  std::unique_ptr<Store> store_;
};

}  // namespace selvage::minkowski

// Basic types: also available in namespace selvage, so that every folder can use them unqualified.
namespace selvage {
using minkowski::SumCache;
}  // namespace selvage
