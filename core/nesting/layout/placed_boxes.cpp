#include "core/nesting/layout/placed_boxes.h"

namespace selvage::nesting::layout {

void PlacedBoxes::take(const Layout& layout) {
  boxes_.resize(set_->size());
  for (std::size_t piece = 0; piece < boxes_.size(); ++piece) boxes_[piece] = placed_box(*set_, layout, piece);
}

void PlacedBoxes::find_near(const RealBox& box, double apart, std::vector<std::uint32_t>& pieces) const {
  constexpr double kRounding = 1e-3;
  const double grown = apart + kRounding;
  const RealBox around{box.low_x - grown, box.low_y - grown, box.high_x + grown, box.high_y + grown};
  pieces.resize(boxes_.size());
  std::size_t found = 0;
  // Without a branch, because which pieces are near cannot be predicted.
  for (std::uint32_t piece = 0; piece < boxes_.size(); ++piece) {
    const RealBox& other = boxes_[piece];
    pieces[found] = piece;
    found += static_cast<std::size_t>(
        static_cast<int>(other.low_x < around.high_x) & static_cast<int>(other.high_x > around.low_x) &
        static_cast<int>(other.low_y < around.high_y) & static_cast<int>(other.high_y > around.low_y));
  }
  pieces.resize(found);
}

}  // namespace selvage::nesting::layout
