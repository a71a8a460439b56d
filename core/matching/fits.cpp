#include "core/matching/fits.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace selvage::matching {
namespace {

constexpr double kGrowth = 1;  // weight of growth across the strip, relative to the difference

Orientation without_tilt(const Orientation& orientation) {
  return {orientation.flip, orientation.rotation, {}};
}

// The tilt of a slot for a piece that lies there; none when the shape may not tilt so far.
Angle allowed_tilt(Angle limit, Angle tilt) {
  return std::abs(tilt.degrees) <= limit.degrees ? tilt : Angle{};
}

// Slots with the same outline and orientation but for tilts are alike.
using SlotKey = std::pair<Orientation, std::uint64_t>;

// The silhouettes of a shape, drawn once for each way in which it lies without tilt.
class DrawnShape {
 public:
  explicit DrawnShape(const Shape& shape) : shape_{shape} {}

  // The fits in all orientations without tilt, the cheapest first.
  [[nodiscard]] std::vector<Fit> into(const Slot& slot, const Silhouette& silhouette) {
    std::vector<Fit> fits;
    for (const Orientation& orientation : orientations_of(shape_, without_tilt(slot.orientation))) {
      const Silhouette& own = drawn(orientation);
      const double difference = estimated_difference(own, silhouette);
      const double growth = std::max(0.0, own.height - silhouette.height) * (own.width + silhouette.width) / 2;
      fits.push_back({difference + kGrowth * growth, difference, orientation});
    }
    std::stable_sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.cost < b.cost; });
    return fits;
  }

 private:
  const Silhouette& drawn(const Orientation& orientation) {
    const auto known = drawn_.find(orientation);
    if (known != drawn_.end()) return known->second;
    return drawn_.emplace(orientation, silhouette_of(oriented(shape_.outline, orientation))).first->second;
  }

  const Shape& shape_;
  std::map<Orientation, Silhouette> drawn_;
};

}  // namespace

Slot slot_of(const Shape& shape, const Orientation& orientation, Vec at) {
  return {shape.id,
          oriented(shape.outline, orientation),
          oriented(shape.outline, without_tilt(orientation)),
          orientation,
          at,
          {}};
}

std::vector<Orientation> orientations_of(const Shape& shape, const Orientation& slot) {
  std::vector<Angle> rotations = shape.rotations;
  if (rotations.empty()) {
    for (const double quarter : {0.0, 90.0, 180.0, 270.0}) rotations.push_back({slot.rotation.degrees + quarter});
  }
  const Angle tilt = allowed_tilt(shape.tilt_limit, slot.tilt);
  std::vector<Orientation> all;
  for (const bool flip : {false, true}) {
    if (flip && !shape.may_flip) continue;
    for (const Angle rotation : rotations) all.push_back({flip, rotation, tilt});
  }
  const Orientation own = without_tilt(slot);
  std::stable_partition(all.begin(), all.end(), [&own](const Orientation& one) { return without_tilt(one) == own; });
  return all;
}

FitTable::FitTable(const Marker& order, std::span<const Slot> slots, const std::stop_token& stop) {
  std::map<SlotKey, std::size_t> kinds;
  std::vector<const Slot*> firsts;
  for (const Slot& slot : slots) {
    Silhouette silhouette = silhouette_of(slot.untilted);
    const Orientation untilted = without_tilt(slot.orientation);
    const auto [kind, fresh] = kinds.try_emplace({untilted, silhouette.hash}, kinds_.size());
    slots_.push_back({slot.orientation.tilt, kind->second});
    if (!fresh) continue;
    kinds_.push_back(silhouette);
    firsts.push_back(&slot);
  }
  for (const Shape& shape : order.shapes) {
    if (stop.stop_requested()) return;
    DrawnShape drawn{shape};
    tilt_limits_.push_back(shape.tilt_limit);
    auto& fits = fits_.emplace_back();
    for (std::size_t k = 0; k < firsts.size(); ++k) fits.push_back(drawn.into(*firsts[k], kinds_[k]));
  }
}

Fit FitTable::tilted(Fit fit, ShapeId shape, std::size_t slot) const {
  fit.orientation.tilt = allowed_tilt(tilt_limits_[shape.value], slots_[slot].tilt);
  return fit;
}

std::vector<Fit> FitTable::all(ShapeId shape, std::size_t slot) const {
  std::vector<Fit> fits = fits_[shape.value][slots_[slot].kind];
  for (Fit& fit : fits) fit = tilted(fit, shape, slot);
  return fits;
}

Fit FitTable::best(ShapeId shape, std::size_t slot) const {
  return tilted(fits_[shape.value][slots_[slot].kind].front(), shape, slot);
}

}  // namespace selvage::matching
