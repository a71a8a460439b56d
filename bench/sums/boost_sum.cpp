#include <boost/polygon/polygon.hpp>
#include <limits>

#include "bench/sums/pair_sum.h"

namespace selvage::bench {
namespace {

namespace bp = boost::polygon;

// Boost.Polygon's correctness is proved for int coordinates; with 64 bits, its predicates are not exact.
using Number = int;
using Set = bp::polygon_set_data<Number>;

Vec middle_of(const Polygon& polygon) {
  const Box box = box_of(polygon);
  return {box.low.x + box.width() / 2, box.low.y + box.height() / 2};
}

Set set_of(const Polygon& polygon, Vec middle) {
  std::vector<bp::point_data<Number>> points;
  for (const Vec v : polygon)
    points.emplace_back(static_cast<Number>(v.x - middle.x), static_cast<Number>(v.y - middle.y));
  Set set;
  set.insert(bp::polygon_data<Number>{points.begin(), points.end()});
  set.clean();
  return set;
}

// Uses coordinates relative to the centres of both polygons, so that they fit into 32 bits.
class BoostSum final : public PairSum {
 public:
  explicit BoostSum(const OutlinePair& pair)
      : p_middle_{middle_of(pair.p->polygon)},
        q_middle_{middle_of(pair.mirrored_q())},
        p_{set_of(pair.p->polygon, p_middle_)},
        q_{set_of(pair.mirrored_q(), q_middle_)} {}
  void make() override {
    Set sum;
    bp::detail::minkowski_offset<Number>::convolve_two_polygon_sets(sum, p_, q_);
    regions_.clear();
    sum.get(regions_);
  }
  [[nodiscard]] test::Difference difference(const test::ExactSum& exact) const override {
    std::vector<Polygon> rings;
    for (const auto& region : regions_) {
      rings.push_back(ring_of(region));
      for (auto hole = region.begin_holes(); hole != region.end_holes(); ++hole) rings.push_back(ring_of(*hole));
    }
    return exact.difference(rings);
  }

 private:
  template <class Ring>
  [[nodiscard]] Polygon ring_of(const Ring& from) const {
    Polygon ring;
    for (const auto& v : from) ring.push_back(p_middle_ + q_middle_ + Vec{v.x(), v.y()});
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    return ring;
  }

  Vec p_middle_, q_middle_;
  Set p_, q_;
  std::vector<bp::polygon_with_holes_data<Number>> regions_;
};

}  // namespace

std::unique_ptr<PairSum> boost_sum(const OutlinePair& pair) {
  const Box p = pair.p->box;
  const Box q = box_of(pair.mirrored_q());
  const Coord extent = std::max(p.width() + q.width(), p.height() + q.height());
  if (extent / 2 + 2 > std::numeric_limits<Number>::max()) return nullptr;
  return std::make_unique<BoostSum>(pair);
}

}  // namespace selvage::bench
