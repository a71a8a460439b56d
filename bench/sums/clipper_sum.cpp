#include <polyclipping/clipper.hpp>

#include "bench/sums/pair_sum.h"

namespace selvage::bench {
namespace {

using ClipperLib::Path;
using ClipperLib::Paths;

Path path_of(const Polygon& polygon) {
  Path path;
  for (const Vec v : polygon) path.emplace_back(v.x, v.y);
  return path;
}

class ClipperSum final : public PairSum {
 public:
  explicit ClipperSum(const OutlinePair& pair)
      : pattern_{path_of(pair.mirrored_q())}, along_{path_of(pair.p->polygon)} {
    // Clipper fills holes of the pattern inside the path, but not holes of the path inside the pattern, so the smaller
    // polygon, which cannot contain the larger, has to be the pattern.
    if (std::abs(ClipperLib::Area(pattern_)) > std::abs(ClipperLib::Area(along_[0]))) std::swap(pattern_, along_[0]);
  }
  void make() override { ClipperLib::MinkowskiSum(pattern_, along_, sum_, true); }
  [[nodiscard]] test::Difference difference(const test::ExactSum& exact) const override {
    std::vector<Polygon> rings;
    for (const Path& path : sum_) {
      Polygon& ring = rings.emplace_back();
      for (const ClipperLib::IntPoint& v : path) ring.push_back({v.X, v.Y});
    }
    return exact.difference(rings);
  }

 private:
  Path pattern_;
  Paths along_;
  Paths sum_;
};

}  // namespace

std::unique_ptr<PairSum> clipper_sum(const OutlinePair& pair) {
  return std::make_unique<ClipperSum>(pair);
}

}  // namespace selvage::bench
