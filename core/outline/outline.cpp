#include "core/outline/outline.h"

namespace selvage::outline {

// FNV-1a over the bytes of the coordinates, least significant byte first.
std::uint64_t hash_of(const Polygon& polygon) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  const auto mix = [&hash](Coord c) {
    auto bits = static_cast<std::uint64_t>(c);
    for (int k = 0; k < 8; ++k, bits >>= 8) hash = (hash ^ (bits & 0xffU)) * 0x100000001b3U;
  };
  for (const Vec v : polygon) {
    mix(v.x);
    mix(v.y);
  }
  return hash;
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
