#include "core/motion/closing/close_gaps.h"

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include <boost/pending/disjoint_sets.hpp>

#include "core/marker/clearance.h"
#include "core/motion/closing/slabs.h"

namespace selvage::motion::closing {
namespace {

using Body = std::vector<std::uint32_t>;  // its pieces, ascending

// The bodies that are not held.
std::vector<Body> loose_bodies(const scene::Scene& scene, Coord near) {
  const std::size_t pieces = scene.pieces.size();
  boost::disjoint_sets_with_storage<> bodies{pieces};
  for (const auto& [p, q] : pairs_within(scene.pieces, near + scene.pieces.widest_spacing())) bodies.union_set(p, q);
  const model::Ties ties = with_match_sets(scene.ties, scene.pieces, scene.marker.strip);
  for (std::size_t k = 0; k < pieces; ++k) {
    // Tied pieces share the number of one of them.
    if (ties.x[k] != model::Ties::kFixed) bodies.union_set(k, static_cast<std::size_t>(ties.x[k]));
  }
  std::vector<char> held(pieces);
  const Coord left = scene.marker.strip.room(0).low.x;
  for (std::size_t k = 0; k < pieces; ++k) {
    const bool holds = ties.x[k] == model::Ties::kFixed || scene.pieces.box(k).low.x - left <= near;
    if (holds) held[bodies.find_set(k)] = 1;
  }
  std::vector<Body> by_set(pieces);
  for (std::uint32_t k = 0; k < pieces; ++k) {
    const std::size_t set = bodies.find_set(static_cast<std::size_t>(k));
    if (held[set] == 0) by_set[set].push_back(k);
  }
  std::erase_if(by_set, [](const Body& body) { return body.empty(); });
  return by_set;
}

Box box_of(const scene::Scene& scene, const Body& body) {
  Box box = scene.pieces.box(body.front());
  for (const std::uint32_t k : body) {
    const Box own = scene.pieces.box(k);
    box = {{std::min(box.low.x, own.low.x), std::min(box.low.y, own.low.y)},
           {std::max(box.high.x, own.high.x), std::max(box.high.y, own.high.y)}};
  }
  return box;
}

// Moves the body to the left as far as the slabs show that it can, if cloth's rules allow that.  True when it moved.
bool move_left(scene::Scene& scene, const Body& body, Slabs& slabs) {
  std::vector<bool> moving(scene.pieces.size());
  for (const std::uint32_t k : body) moving[k] = true;
  const Box box = box_of(scene, body);
  const Coord by = std::min(slabs.free_distance(moving, box), box.low.x - scene.marker.strip.room(0).low.x);
  if (by <= 0 || !are_clear(scene.pieces, moving, {-by, 0})) return false;
  const std::vector<Vec> before = scene.pieces.positions();
  std::vector<Vec> after = before;
  for (const std::uint32_t k : body) after[k].x -= by;
  scene.pieces.place(std::move(after));
  if (!are_inside(scene.pieces, scene.marker.strip)) {
    scene.pieces.place(before);
    return false;
  }
  slabs.move(moving, box, by);
  return true;
}

}  // namespace

bool close_gaps(scene::Scene& scene, Coord near, std::size_t many, const scene::Run& run) {
  const std::vector<Body> bodies = loose_bodies(scene, near);
  std::size_t pieces = 0;
  for (const Body& body : bodies) pieces += body.size();
  if (pieces < many) return false;
  std::vector<std::pair<Coord, std::size_t>> order;
  for (std::size_t k = 0; k < bodies.size(); ++k) order.emplace_back(box_of(scene, bodies[k]).low.x, k);
  std::sort(order.begin(), order.end());
  Slabs slabs{scene.pieces, scene.marker.strip.width};
  bool moved = false;
  for (const auto& [x, k] : order) {
    if (run.stopped()) break;
    moved = move_left(scene, bodies[k], slabs) || moved;
  }
  return moved;
}

}  // namespace selvage::motion::closing
