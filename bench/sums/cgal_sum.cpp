#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_2.h>
#include <CGAL/Polygon_with_holes_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <optional>

#include "bench/sums/pair_sum.h"

namespace selvage::bench {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Exact = CGAL::Polygon_2<Kernel>;

Exact exact_polygon(const Polygon& polygon) {
  Exact exact;
  for (const Vec v : polygon) exact.push_back({static_cast<double>(v.x), static_cast<double>(v.y)});
  return exact;
}

class CgalSum final : public PairSum {
 public:
  explicit CgalSum(const OutlinePair& pair)
      : p_{exact_polygon(pair.p->polygon)}, q_{exact_polygon(pair.mirrored_q())} {}
  void make() override { sum_.emplace(CGAL::minkowski_sum_2(p_, q_)); }
  [[nodiscard]] test::Difference difference(const test::ExactSum& exact) const override {
    std::vector<Polygon> rings{rounded(sum_->outer_boundary())};
    for (const Exact& hole : sum_->holes()) rings.push_back(rounded(hole));
    return exact.difference(rings);
  }

 private:
  static Polygon rounded(const Exact& ring) {
    Polygon polygon;
    for (const auto& v : ring.vertices()) {
      const Vec corner{std::llround(CGAL::to_double(v.x())), std::llround(CGAL::to_double(v.y()))};
      if (polygon.empty() || polygon.back() != corner) polygon.push_back(corner);
    }
    return polygon;
  }

  Exact p_, q_;
  std::optional<CGAL::Polygon_with_holes_2<Kernel>> sum_;
};

}  // namespace

std::unique_ptr<PairSum> cgal_sum(const OutlinePair& pair) {
  return std::make_unique<CgalSum>(pair);
}

}  // namespace selvage::bench
