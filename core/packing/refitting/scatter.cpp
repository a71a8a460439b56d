#include "core/packing/refitting/scatter.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/marker/clearance.h"
#include "core/motion/placing/place.h"
#include "core/packing/bodies/on_cloth.h"
#include "core/scene/scene.h"

namespace selvage::packing::refitting {
namespace {

// Those that the piece may take, in random order.
std::vector<Orientation> orientations_of(const Marker& marker, const Piece& piece, bool turns,
                                         std::mt19937_64& random) {
  const Shape& shape = marker.shapes[piece.shape.value];
  if (!turns || piece.locked.tilt || shape.rotations.empty()) return {piece.orientation};
  std::vector<Orientation> all;
  for (const bool flip : {false, true}) {
    for (const Angle rotation : shape.rotations) {
      if (!flip || shape.may_flip) all.push_back({flip, rotation, piece.orientation.tilt});
    }
  }
  for (std::size_t k = all.size(); k > 1; --k) std::swap(all[k - 1], all[random() % k]);
  return all;
}

// The marker with one of its unplaced pieces placed.
std::optional<Marker> with_piece(const Marker& marker, std::size_t unplaced, Coord end, bool turns,
                                 std::mt19937_64& random, const scene::Run& run) {
  const std::array wanted{bodies::unplaced_piece(marker, unplaced)};
  bodies::OnCloth cloth = bodies::on_cloth(marker, wanted);
  cloth.marker.strip = marker.strip.ending(end);
  const PieceId id = cloth.wanted.front();
  const std::vector<Orientation> orientations = orientations_of(marker, cloth.marker.pieces[id.value], turns, random);
  scene::Scene scene{std::move(cloth.marker), run.sums};
  const auto below = [&random](Coord most) { return static_cast<Coord>(random() % static_cast<std::uint64_t>(most)); };
  const Vec point{below(std::max<Coord>(1, end)), below(marker.strip.width)};
  for (const Orientation& orientation : orientations) {
    scene.reorient(id, orientation, {});
    if (!may_lie(scene.marker, scene.marker.pieces[id.value])) continue;
    const auto place = motion::placing::place(scene, id, point, {.tuning = {}, .stop = run.stop});
    if (!place) continue;
    Marker placed = scene.result();
    placed.strip = marker.strip;
    placed.pieces[id.value].orientation = orientation;
    placed.pieces[id.value].at = place->at;
    return placed;
  }
  return std::nullopt;
}

}  // namespace

Scattered scattered(const Marker& marker, Coord end, bool turns, std::mt19937_64& random, const scene::Run& run) {
  Scattered done{marker};
  while (done.layout && !done.layout->unplaced.empty()) {
    if (run.stopped()) return {};
    const Marker& layout = *done.layout;
    const auto area = [&layout](const Piece& piece) { return doubled_area(layout.shapes[piece.shape.value].outline); };
    const auto largest = std::ranges::max_element(layout.unplaced, {}, area);
    const auto number = static_cast<std::size_t>(largest - layout.unplaced.begin());
    done.layout = with_piece(layout, number, end, turns, random, run);
    if (done.layout) ++done.placed;
  }
  return done;
}

}  // namespace selvage::packing::refitting
