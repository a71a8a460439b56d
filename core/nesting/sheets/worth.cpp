#include "core/nesting/sheets/worth.h"

#include <algorithm>
#include <cmath>

namespace selvage::nesting::sheets {
namespace {

// The weights of pieces without values are proportional to their areas to the power of one more than this.
constexpr double kHardness = 0.3;

}  // namespace

Worth worth_of(const Marker& marker, std::span<const Piece> pieces,
               const std::map<std::string, double, std::less<>>& given) {
  Worth worth;
  for (const Piece& piece : pieces) {
    worth.area.push_back(geometry::area_of(marker.shapes[piece.shape.value].outline));
  }
  const double largest = pieces.empty() ? 0 : *std::max_element(worth.area.begin(), worth.area.end());
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto found = given.find(pieces[k].id);
    const double area = worth.area[k];
    worth.value.push_back(found == given.end() ? area : found->second);
    worth.weight.push_back(found == given.end() ? area * std::pow(area / largest, kHardness) : found->second);
  }
  return worth;
}

}  // namespace selvage::nesting::sheets
