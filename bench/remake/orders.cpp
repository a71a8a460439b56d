#include "bench/remake/orders.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace selvage::bench {
namespace {

// Unlike the standard library's distributions, this gives the same numbers on every platform.
class Choices {
 public:
  explicit Choices(std::uint64_t seed) : random_{seed} {}
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  template <class Value>
  void shuffle(std::vector<Value>& values) {
    for (std::size_t k = values.size(); k > 1; --k) std::swap(values[k - 1], values[random_() % k]);
  }

 private:
  std::mt19937_64 random_;
};

std::string size_of(const Json& attributes) {
  return attributes.contains("size") ? protocol::json::to_text(attributes["size"]) : std::string{};
}

// The shape with another outline, if that is valid and fits the strip in the same allowed
// orientations.
void change_outline(const Marker& marker, Shape& shape, const Polygon& outline) {
  const auto clean = geometry::clean_polygon(outline);
  if (!clean) return;
  const Coord room = marker.strip.width - 2 * marker.strip.margin;
  for (const Angle rotation : shape.rotations) {
    const Orientation orientation{false, rotation, {}};
    const bool fitted = box_of(oriented(shape.outline, orientation)).height() <= room;
    if (fitted && box_of(oriented(clean->polygon, orientation)).height() > room) return;
  }
  shape.outline = clean->polygon;
}

Polygon scaled(const Polygon& outline, double factor) {
  Polygon changed = outline;
  for (Vec& v : changed) {
    v = {std::llround(static_cast<double>(v.x) * factor), std::llround(static_cast<double>(v.y) * factor)};
  }
  return changed;
}

// How shapes with one outline are changed.
struct Reshaping {
  double along, across, bend;
};

Polygon reshaped(const Polygon& outline, const Reshaping& by) {
  const Box box = box_of(outline);
  const auto length = static_cast<double>(box.width());
  const auto height = static_cast<double>(box.height());
  Polygon changed = outline;
  for (Vec& v : changed) {
    const double x = static_cast<double>(v.x - box.low.x);
    const double y = static_cast<double>(v.y - box.low.y);
    const double bent = by.bend * height * std::sin(std::numbers::pi * x / length);
    v = {std::llround(x * (1 + by.along)), std::llround(y * (1 + by.across) + bent)};
  }
  return changed;
}

void grade(Marker& marker, const std::vector<Json>& attributes, double part, Choices& choices) {
  std::vector<std::string> sizes;  // by shape
  for (const Json& shape : attributes) sizes.push_back(size_of(shape));
  if (std::ranges::all_of(sizes, &std::string::empty)) {
    for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = std::to_string(k);
  }
  std::map<std::string, double> factors;
  for (const std::string& size : sizes) factors.emplace(size, 1);
  std::vector<double> spread;
  for (std::size_t k = 0; k < factors.size(); ++k) {
    const auto steps = static_cast<double>(std::max<std::size_t>(1, factors.size() - 1));
    spread.push_back(1 + part * (2 * static_cast<double>(k) / steps - 1));
  }
  choices.shuffle(spread);
  for (std::size_t k = 0; auto& [size, factor] : factors) factor = spread[k++];
  for (std::size_t k = 0; k < marker.shapes.size(); ++k) {
    change_outline(marker, marker.shapes[k], scaled(marker.shapes[k].outline, factors.at(sizes[k])));
  }
}

void reshape(Marker& marker, double part, Choices& choices) {
  std::map<Polygon, Reshaping> changes;
  for (Shape& shape : marker.shapes) {
    const auto [found, fresh] = changes.try_emplace(shape.outline);
    if (fresh) {
      found->second.along = choices.between(-part, part);
      found->second.across = choices.between(-part, part);
      found->second.bend = choices.between(-part, part);
    }
    change_outline(marker, shape, reshaped(shape.outline, found->second));
  }
}

void recount(Marker& marker, double part, Choices& choices) {
  const auto count = static_cast<std::size_t>(std::llround(part * static_cast<double>(marker.unplaced.size())));
  const bool fewer = choices.between(0, 1) < 0.5;
  choices.shuffle(marker.unplaced);
  if (fewer) {
    marker.unplaced.resize(marker.unplaced.size() - count);
    return;
  }
  for (std::size_t k = 0; k < count; ++k) {
    Piece piece = marker.unplaced[k];
    piece.id += "+";
    marker.unplaced.push_back(std::move(piece));
  }
}

// How many bundles of a size the marker has: the greatest number that divides the counts of all its shapes.
struct SizeBundles {
  std::map<std::uint32_t, std::size_t> counts;  // of pieces, by shape
  std::size_t bundles{};
};

void mix(Marker& marker, const std::vector<Json>& attributes, double times, Choices& choices) {
  std::map<std::string, SizeBundles> sizes;
  for (const Piece& piece : marker.unplaced) ++sizes[size_of(attributes[piece.shape.value])].counts[piece.shape.value];
  std::vector<SizeBundles> of_size;
  std::size_t bundles = 0;
  for (auto& [name, size] : sizes) {
    for (const auto& [shape, count] : size.counts) size.bundles = std::gcd(size.bundles, count);
    bundles += size.bundles;
    of_size.push_back(size);
  }
  if (times > 0) bundles *= static_cast<std::size_t>(times);
  std::vector<Piece> pieces;
  for (std::size_t k = 0; k < bundles; ++k) {
    const auto drawn = static_cast<std::size_t>(choices.between(0, static_cast<double>(of_size.size())));
    const SizeBundles& size = of_size[drawn];
    for (const auto& [shape, count] : size.counts) {
      for (std::size_t copy = 0; copy < count / size.bundles; ++copy) {
        Piece piece;
        piece.id = "p" + std::to_string(pieces.size() + 1);
        piece.shape = ShapeId{shape};
        pieces.push_back(std::move(piece));
      }
    }
  }
  marker.unplaced = std::move(pieces);
}

}  // namespace

std::string_view name_of(Change change) {
  static constexpr std::string_view kNames[] = {"graded", "larger", "reshaped", "counts", "mixed"};
  return kNames[static_cast<std::size_t>(change)];
}

Marker order_of(const MarkerFile& file, Change change, double part, std::uint64_t seed) {
  Marker marker = file.marker;
  for (Piece& piece : marker.pieces) {
    piece.at = {};
    piece.orientation.tilt = {};
    marker.unplaced.push_back(piece);
  }
  marker.pieces.clear();
  Choices choices{seed};
  switch (change) {
    case Change::kGraded: grade(marker, file.attributes.shapes, part, choices); break;
    case Change::kLarger:
      for (Shape& shape : marker.shapes) change_outline(marker, shape, scaled(shape.outline, 1 + part));
      break;
    case Change::kReshaped: reshape(marker, part, choices); break;
    case Change::kCounts: recount(marker, part, choices); break;
    case Change::kMixed: mix(marker, file.attributes.shapes, part, choices); break;
  }
  return marker;
}

}  // namespace selvage::bench
