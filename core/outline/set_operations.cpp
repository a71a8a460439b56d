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
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
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
