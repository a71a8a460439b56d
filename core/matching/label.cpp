#include "core/matching/label.h"

namespace selvage::matching {

Label label_of(const LabelledMarker& marker, std::size_t piece) {
  return piece < marker.labels.size() ? marker.labels[piece] : Label{};
}

}  // namespace selvage::matching
