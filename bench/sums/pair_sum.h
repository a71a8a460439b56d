// A pair of polygons in a library's own representation, and their Minkowski sum computed by that library; sum_table
// compares the libraries.
//
// The polygons are converted beforehand; only make() is timed.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "core/outline/outline.h"
#include "tests/support/exact.h"

namespace selvage::bench {

// P, and Q relative to P: the sum is that of P and -(Q under `relative`).
struct OutlinePair {
  std::shared_ptr<const outline::Outline> p, q;
  Symmetry relative;
  [[nodiscard]] Polygon mirrored_q() const { return transformed(q->polygon, Symmetry{false, 2}.after(relative)); }
  [[nodiscard]] std::size_t vertices() const { return p->polygon.size() + q->polygon.size(); }
};

class PairSum {
 public:
  PairSum() = default;
  PairSum(const PairSum&) = delete;
  PairSum& operator=(const PairSum&) = delete;
  virtual ~PairSum() = default;
  // Computes the sum again, releasing the previous one.
  virtual void make() = 0;
  // The difference of the last sum from the exact one.
  [[nodiscard]] virtual test::Difference difference(const test::ExactSum& exact) const = 0;
};

struct Library {
  const char* name;
  std::unique_ptr<PairSum> (*prepared)(const OutlinePair& pair);
};

[[nodiscard]] std::unique_ptr<PairSum> selvage_sum(const OutlinePair& pair);
// CGAL's minkowski_sum_2 with the exact kernel, which uses the reduced convolution.
[[nodiscard]] std::unique_ptr<PairSum> cgal_sum(const OutlinePair& pair);
// ClipperLib::MinkowskiSum of the smaller polygon along the larger, which unites a quadrilateral for each pair of
// edges.
[[nodiscard]] std::unique_ptr<PairSum> clipper_sum(const OutlinePair& pair);
// Boost.Polygon's convolution of polygon sets, which does the same.  Null for a pair too large for 32 bits.
[[nodiscard]] std::unique_ptr<PairSum> boost_sum(const OutlinePair& pair);

}  // namespace selvage::bench
