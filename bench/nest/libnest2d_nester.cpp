#include "bench/nest/libnest2d_nester.h"

#include <algorithm>
#include <libnest2d/libnest2d.hpp>

namespace selvage::bench {
namespace {

using Placer = libnest2d::NfpPlacer;

constexpr double kUpwards = 1e-3;  // weight of a low position, compared with one far left
constexpr double kOutside = 100;   // penalty for leaving the strip
constexpr double kDegree = 3.14159265358979323846 / 180;

// Converts to libnest2d's form of polygons: clockwise and closed.
libnest2d::Item hull_of(const std::vector<NestedPoint>& outline) {
  ClipperLib::Path contour;
  for (auto v = outline.rbegin(); v != outline.rend(); ++v) contour.emplace_back(v->first, v->second);
  contour.push_back(contour.front());
  return libnest2d::Item{libnest2d::shapelike::convexHull(libnest2d::PolygonImpl{contour})};
}

Placer::Config leftmost_first(const std::vector<double>& rotations, const libnest2d::Box& strip) {
  Placer::Config config;
  config.rotations.clear();
  for (const double rotation : rotations) config.rotations.emplace_back(rotation * kDegree);
  config.alignment = Placer::Config::Alignment::DONT_ALIGN;
  config.starting_point = Placer::Config::Alignment::BOTTOM_LEFT;
  config.object_function = [strip](const libnest2d::Item& item) {
    const auto box = item.boundingBox();
    const auto low = box.minCorner();
    const auto high = box.maxCorner();
    const auto end = strip.maxCorner();
    const auto across = [&](ClipperLib::cInt value) { return static_cast<double>(value) / static_cast<double>(end.Y); };
    const auto outside = std::max<ClipperLib::cInt>({0, -low.X, -low.Y, high.X - end.X, high.Y - end.Y});
    return across(high.X) + kUpwards * across(high.Y) + (outside > 0 ? kOutside * (1 + across(outside)) : 0);
  };
  return config;
}

}  // namespace

std::vector<NestedPiece> nest(const std::vector<std::vector<NestedPoint>>& outlines,
                              const std::vector<double>& rotations, std::int64_t length, std::int64_t width) {
  std::vector<libnest2d::Item> items;
  for (const auto& outline : outlines) items.push_back(hull_of(outline));
  const libnest2d::Box strip{{0, 0}, {length, width}};
  libnest2d::nest<Placer>(items, strip, 0, {leftmost_first(rotations, strip)});
  std::vector<NestedPiece> pieces;
  for (const libnest2d::Item& item : items) {
    const libnest2d::Radians turned = item.rotation();
    const libnest2d::Point at = item.translation();
    if (item.binId() != 0) return {};
    pieces.push_back({static_cast<double>(turned) / kDegree, {at.X, at.Y}});
  }
  return pieces;
}

}  // namespace selvage::bench
