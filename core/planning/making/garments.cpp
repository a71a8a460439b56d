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
    marker_.shade = style.shade;
  }

  // The pieces that follow are those of a new bundle, this one of its size.
  void begin(int bundle) {
    bundle_ = bundle;
    own_shades_.clear();
  }

  void add(const Piece& piece) {
    Piece copy = piece;
    const auto [known, fresh] = shapes_.try_emplace(piece.shape, static_cast<std::uint32_t>(marker_.shapes.size()));
    if (fresh) marker_.shapes.push_back(style_.shapes[piece.shape.value]);
    copy.shape = {known->second};
    copy.at = {};
    copy.locked = {false, false, piece.locked.tilt};
    copy.group.clear();
    copy.id = numbered(piece.id);
    while (!ids_.insert(copy.id).second) copy.id += "'";
    if (!piece.rules.shade.empty()) copy.rules.shade = own_shade(piece.rules.shade);
    marker_.unplaced.push_back(std::move(copy));
  }
  [[nodiscard]] Marker take() { return std::move(marker_); }

 private:
  [[nodiscard]] std::string numbered(const std::string& name) const {
    return bundle_ > 0 ? name + " #" + std::to_string(bundle_ + 1) : name;
  }

  // The name in this bundle of a shade of the style; no other bundle has it.
  const std::string& own_shade(const std::string& shade) {
    const auto [known, fresh] = own_shades_.try_emplace(shade);
    if (!fresh) return known->second;
    std::string own = numbered(shade);
    while (!shades_.insert(own).second) own += "'";
    return known->second = std::move(own);
  }

  const Marker& style_;
  Marker marker_;
  std::map<ShapeId, std::uint32_t> shapes_;
  std::set<std::string> ids_, shades_;
  int bundle_{};
  std::map<std::string, std::string> own_shades_;  // of this bundle, by those of the style
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
      bundler.begin(bundle);
      for (const std::size_t position : garments.sizes[size]) bundler.add(piece_at(garments.style, position));
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
