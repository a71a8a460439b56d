#include "core/outline/set_operations.h"

#include <algorithm>
#include <polyclipping/clipper.hpp>
#include <utility>

namespace selvage::outline {
namespace {

constexpr double kMitre = 2;  // corners extend at most this many times the distance

ClipperLib::Path path_of(std::span<const Vec> polygon) {
  ClipperLib::Path path;
  path.reserve(polygon.size());
  for (const Vec v : polygon) path.emplace_back(v.x, v.y);
  return path;
}

// The library sweeps along y, and its cost grows with the number of edges that cross the sweep line.  Markers are long
// in x, so polygons are turned by a quarter: the sweep line is then only as long as the strip is wide.
Vec turned(Vec v) {
  return {-v.y, v.x};
}
Vec turned_back(Vec v) {
  return {v.y, -v.x};
}

Polygon turned(Polygon ring) {
  for (Vec& v : ring) v = turned(v);
  return ring;
}

// The path as a ring that starts at its smallest vertex.
Polygon ring_of(const ClipperLib::Path& path) {
  Polygon ring;
  ring.reserve(path.size());
  for (const ClipperLib::IntPoint& point : path) ring.push_back({point.X, point.Y});
  return geometry::normal_form(std::move(ring));
}

Polygon ring_turned_back(ClipperLib::Path path) {
  for (ClipperLib::IntPoint& point : path) {
    const Vec v = turned_back({point.X, point.Y});
    point = {v.x, v.y};
  }
  return ring_of(path);
}

// Appends the regions of a tree in which outlines are at even depths and their holes one level deeper.
void collect(const ClipperLib::PolyNode& parent, std::vector<Region>& regions) {
  for (const ClipperLib::PolyNode* outline : parent.Childs) {
    Region region{ring_turned_back(outline->Contour), {}};
    for (const ClipperLib::PolyNode* hole : outline->Childs) {
      region.holes.push_back(ring_turned_back(hole->Contour));
      collect(*hole, regions);
    }
    std::sort(region.holes.begin(), region.holes.end());
    regions.push_back(std::move(region));
  }
}

}  // namespace

std::vector<Polygon> grown(std::span<const Vec> polygon, Coord distance) {
  if (distance <= 0) return {Polygon(polygon.begin(), polygon.end())};
  ClipperLib::ClipperOffset offset{kMitre};
  offset.AddPath(path_of(polygon), ClipperLib::jtMiter, ClipperLib::etClosedPolygon);
  ClipperLib::Paths paths;
  offset.Execute(paths, static_cast<double>(distance));
  std::vector<Polygon> rings;
  rings.reserve(paths.size());
  for (const ClipperLib::Path& path : paths) rings.push_back(ring_of(path));
  return rings;
}

Polygon widened(std::span<const Vec> polygon, const Box& by) {
  const Vec corners[] = {by.low, {by.high.x, by.low.y}, by.high, {by.low.x, by.high.y}};
  ClipperLib::Clipper clipper{ClipperLib::ioStrictlySimple};
  const auto add = [&clipper](const Polygon& ring) {
    ClipperLib::Path path = path_of(ring);
    if (!ClipperLib::Orientation(path)) ClipperLib::ReversePath(path);
    clipper.AddPath(path, ClipperLib::ptSubject, true);
  };
  add(Polygon(polygon.begin(), polygon.end()));
  // A box that moves along an edge covers itself at both ends, and the parallelogram of one of its diagonals.
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec p = polygon[k], q = polygon[k + 1 == polygon.size() ? 0 : k + 1];
    add({p + corners[0], p + corners[1], p + corners[2], p + corners[3]});
    for (const std::size_t c : {0U, 1U}) add({p + corners[c], q + corners[c], q + corners[c + 2], p + corners[c + 2]});
  }
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  return ring_of(tree.Childs.front()->Contour);
}

Polygon outer_boundary(std::span<const Vec> ring) {
  ClipperLib::Clipper clipper{ClipperLib::ioStrictlySimple};
  clipper.AddPath(path_of(ring), ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  const auto largest = std::max_element(tree.Childs.begin(), tree.Childs.end(),
                                        [](const ClipperLib::PolyNode* a, const ClipperLib::PolyNode* b) {
                                          return ClipperLib::Area(a->Contour) < ClipperLib::Area(b->Contour);
                                        });
  return largest == tree.Childs.end() ? Polygon{} : ring_of((*largest)->Contour);
}

std::vector<Region> left_over(const Box& box, const std::vector<Polygon>& taken) {
  ClipperLib::Clipper clipper{ClipperLib::ioStrictlySimple};
  const Polygon whole{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};
  clipper.AddPath(path_of(turned(whole)), ClipperLib::ptSubject, true);
  for (const Polygon& ring : taken) clipper.AddPath(path_of(turned(ring)), ClipperLib::ptClip, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctDifference, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<Region> regions;
  collect(tree, regions);
  std::sort(regions.begin(), regions.end());
  return regions;
}

}  // namespace selvage::outline
