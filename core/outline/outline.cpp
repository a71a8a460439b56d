#include "core/outline/outline.h"

#include "core/base/fnv1a.h"

namespace selvage::outline {

std::uint64_t hash_of(const Polygon& polygon) {
  Fnv1a hash;
  for (const Vec v : polygon) hash.add(static_cast<std::uint64_t>(v.x)).add(static_cast<std::uint64_t>(v.y));
  return hash.value();
}

std::size_t Outline::bytes() const {
  std::size_t total = sizeof *this + polygon.capacity() * sizeof(Vec);
  for (const StarPart& part : parts) {
    total += sizeof part + part.vertices.capacity() * sizeof(Vec) + part.origin.capacity() * sizeof(std::uint32_t) +
             part.turns.capacity() * sizeof(Turn);
  }
  return total;
}

std::shared_ptr<const Outline> make_outline(Polygon polygon) {
  auto outline = std::make_shared<Outline>();
  outline->box = box_of(polygon);
  outline->convex = is_convex(polygon);
  outline->parts = star_parts(polygon);
  outline->hash = hash_of(polygon);
  outline->polygon = std::move(polygon);
  return outline;
}

}  // namespace selvage::outline
