#include "core/motion/sections/section_scene.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "core/model/ties.h"

namespace selvage::motion::sections {
namespace {

// The marker of all these pieces, without any.
Marker empty_marker(const Marker& whole) {
  Marker part;
  part.unit = whole.unit;
  part.resolution = whole.resolution;
  part.strip = whole.strip.ending({});
  part.spacing = whole.spacing;
  part.overlap = whole.overlap;
  part.shapes = whole.shapes;
  return part;
}

// So far to the left that the left layer lies within the strip.
Vec origin_of(const Section& section, const scene::Scene& whole) {
  if (section.left.empty()) return {};
  Coord leftmost = section.from;
  for (const std::uint32_t i : section.left) leftmost = std::min(leftmost, whole.pieces.box(i).low.x);
  return {leftmost - whole.marker.strip.margin, 0};
}

}  // namespace

bool can_be_divided(const scene::Scene& scene) {
  const auto moves_alone = [](std::vector<std::uint32_t> ties) {
    std::sort(ties.begin(), ties.end());
    const bool any_fixed = !ties.empty() && ties.back() == model::Ties::kFixed;
    return !any_fixed && std::adjacent_find(ties.begin(), ties.end()) == ties.end();
  };
  return std::none_of(scene.marker.pieces.begin(), scene.marker.pieces.end(),
                      [](const Piece& piece) { return piece.rules != marker::Rules{}; }) &&
         moves_alone(scene.ties.x) && moves_alone(scene.ties.y);
}

SectionScene scene_of(const Section& section, const scene::Scene& whole, const scene::Run& run) {
  const Vec origin = origin_of(section, whole);
  Marker part = empty_marker(whole.marker);
  const auto add = [&](const Pieces& pieces, std::optional<Coord> from) {
    for (const std::uint32_t i : pieces) {
      Piece piece = whole.marker.pieces[i];
      piece.at = whole.pieces.at(i) - origin;
      piece.rules.from = from;
      part.pieces.push_back(std::move(piece));
    }
  };
  add(section.free, section.left.empty() ? std::nullopt : std::optional{section.from - origin.x});
  add(section.left, {});
  add(section.right, {});
  SectionScene result{scene::Scene{std::move(part), run}, origin};
  model::Ties& ties = result.scene.ties;
  const std::size_t fixed = section.free.size();
  const std::size_t body = fixed + section.left.size();
  for (std::size_t i = fixed; i < ties.x.size(); ++i) {
    ties.x[i] = i < body ? model::Ties::kFixed : static_cast<std::uint32_t>(body);
    ties.y[i] = model::Ties::kFixed;
  }
  return result;
}

MovedSection moved_section(const Section& section, const SectionScene& done, const scene::Scene& whole) {
  MovedSection moved;
  const marker::PlacedPieces& pieces = done.scene.pieces;
  for (std::size_t k = 0; k < section.free.size(); ++k) moved.positions.push_back(pieces.at(k) + done.origin);
  if (!section.right.empty()) {
    const std::size_t body = section.free.size() + section.left.size();
    moved.shift = pieces.at(body).x + done.origin.x - whole.pieces.at(section.right.front()).x;
  }
  return moved;
}

}  // namespace selvage::motion::sections
