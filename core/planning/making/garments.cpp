#include "core/planning/making/garments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/planning/making/mirror.h"

namespace selvage::planning::making {
namespace {

const Piece& piece_at(const Marker& style, std::size_t position) {
  const std::size_t placed = style.pieces.size();
  return position < placed ? style.pieces[position] : style.unplaced[position - placed];
}

double perimeter_of(const Polygon& outline) {
  double perimeter = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Vec edge = outline[(k + 1) % outline.size()] - outline[k];
    perimeter += std::hypot(static_cast<double>(edge.x), static_cast<double>(edge.y));
  }
  return perimeter;
}

// Adds pieces to a marker, with the shapes that they need.
class Bundler {
 public:
  explicit Bundler(const Marker& style) : style_{style} {
    marker_.name = style.name;
    marker_.unit = style.unit;
    marker_.resolution = style.resolution;
    marker_.strip = style.strip;
    marker_.strip.longest.reset();
    marker_.spacing = style.spacing;
    marker_.overlap = style.overlap;
  }

  void add(const Piece& piece, int bundle) {
    Piece copy = piece;
    const auto [known, fresh] = shapes_.try_emplace(piece.shape, static_cast<std::uint32_t>(marker_.shapes.size()));
    if (fresh) marker_.shapes.push_back(style_.shapes[piece.shape.value]);
    copy.shape = {known->second};
    copy.at = {};
    copy.locked = {false, false, piece.locked.tilt};
    copy.group.clear();
    if (bundle > 0) copy.id += " #" + std::to_string(bundle + 1);
    while (!ids_.insert(copy.id).second) copy.id += "'";
    marker_.unplaced.push_back(std::move(copy));
  }
  [[nodiscard]] Marker take() { return std::move(marker_); }

 private:
  const Marker& style_;
  Marker marker_;
  std::map<ShapeId, std::uint32_t> shapes_;
  std::set<std::string> ids_;
};

}  // namespace

orders::Size measured(const Garments& garments, std::size_t size, std::string name) {
  const double unit = std::pow(10.0, garments.style.resolution.exponent);
  orders::Size one{std::move(name), 0, 0};
  for (const std::size_t position : garments.sizes[size]) {
    const Polygon& outline = garments.style.shapes[piece_at(garments.style, position).shape.value].outline;
    one.area += geometry::area_of(outline) * unit * unit;
    one.perimeter += perimeter_of(outline) * unit;
  }
  return one;
}

Marker bundles_of(const Garments& garments, const orders::Ratio& ratio) {
  Bundler bundler{garments.style};
  for (std::size_t size = 0; size < ratio.size(); ++size) {
    for (int bundle = 0; bundle < ratio[size]; ++bundle) {
      for (const std::size_t position : garments.sizes[size]) bundler.add(piece_at(garments.style, position), bundle);
    }
  }
  return bundler.take();
}

std::optional<std::size_t> piece_without_mirror_image(const Garments& garments, std::size_t size, double slack) {
  const std::vector<std::size_t>& positions = garments.sizes[size];
  const auto outline = [&](std::size_t k) {
    const Piece& piece = piece_at(garments.style, positions[k]);
    return std::pair{&garments.style.shapes[piece.shape.value].outline, piece.orientation.flip};
  };
  std::vector<char> paired(positions.size());
  for (std::size_t k = 0; k < positions.size(); ++k) {
    if (paired[k] != 0) continue;
    const auto [own, flipped] = outline(k);
    const bool self = are_mirror_images(*own, *own, slack);
    if (self) continue;
    std::size_t other = k + 1;
    for (; other < positions.size(); ++other) {
      if (paired[other] != 0) continue;
      const auto [its, its_flip] = outline(other);
      const bool pair = its_flip == flipped ? are_mirror_images(*own, *its, slack) : own == its;
      if (pair) break;
    }
    if (other == positions.size()) return positions[k];
    paired[k] = paired[other] = 1;
  }
  return std::nullopt;
}

}  // namespace selvage::planning::making
