#include "core/model/snap.h"

#include <algorithm>
#include <cmath>

namespace selvage::model {
namespace {

// The shift t in [0, 1] that keeps all values, once added, away from whole numbers.  0 counts as one of the values: a
// piece that does not move must stay.
double shift_for(std::vector<double> values) {
  for (double& v : values) v -= std::floor(v);
  values.push_back(0);
  std::sort(values.begin(), values.end());
  double widest = 1 - values.back();  // the gap around 1
  double middle = (1 + values.back()) / 2;
  for (std::size_t k = 0; k + 1 < values.size(); ++k) {
    if (values[k + 1] - values[k] > widest) {
      widest = values[k + 1] - values[k];
      middle = (values[k + 1] + values[k]) / 2;
    }
  }
  return 1 - middle;  // fractions below the middle round down, those above round up
}

}  // namespace

std::vector<Vec> snapped(std::span<const RealVec> displacements) {
  std::vector<double> xs;
  std::vector<double> ys;
  for (const RealVec& d : displacements) {
    xs.push_back(d.x);
    ys.push_back(d.y);
  }
  const double tx = shift_for(xs);
  const double ty = shift_for(ys);
  std::vector<Vec> moves;
  moves.reserve(displacements.size());
  for (const RealVec& d : displacements) {
    moves.push_back({static_cast<Coord>(std::floor(d.x + tx)), static_cast<Coord>(std::floor(d.y + ty))});
  }
  return moves;
}

}  // namespace selvage::model
