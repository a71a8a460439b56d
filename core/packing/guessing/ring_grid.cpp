#include "core/packing/guessing/ring_grid.h"

#include <algorithm>

namespace selvage::packing::guessing {

RingGrid::RingGrid(const RealBox& range, std::span<const RealBox> boxes)
    : range_{range},
      parts_x_{kParts / std::max(range.width(), 1.0)},
      parts_y_{kParts / std::max(range.height(), 1.0)},
      begins_(kParts * kParts + 1) {
  const auto for_each_part = [this](const RealBox& box, const auto& visit) {
    const std::size_t first = part_of({box.low_x, box.low_y});
    const std::size_t last = part_of({box.high_x, box.high_y});
    for (std::size_t row = first / kParts; row <= last / kParts; ++row) {
      for (std::size_t column = first % kParts; column <= last % kParts; ++column) visit(row * kParts + column);
    }
  };
  for (const RealBox& box : boxes) {
    for_each_part(box, [this](std::size_t part) { ++begins_[part + 1]; });
  }
  for (std::size_t part = 0; part < kParts * kParts; ++part) begins_[part + 1] += begins_[part];
  rings_.resize(begins_.back());
  std::vector<std::uint32_t> ends{begins_.begin(), begins_.end() - 1};
  for (std::uint32_t ring = 0; ring < boxes.size(); ++ring) {
    for_each_part(boxes[ring], [&](std::size_t part) { rings_[ends[part]++] = ring; });
  }
}

std::size_t RingGrid::along(double value, double low, double parts) {
  const double part = std::clamp((value - low) * parts, 0.0, static_cast<double>(kParts - 1));
  return static_cast<std::size_t>(part);
}

}  // namespace selvage::packing::guessing
