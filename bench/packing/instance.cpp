#include "bench/packing/instance.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/geometry/polygon.h"

namespace selvage::bench {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& reason) {
  std::fprintf(stderr, "%s: %s\n", path.c_str(), reason.c_str());
  std::exit(1);
}

using Points = std::vector<std::pair<double, double>>;

struct Extent {
  int decimals{};
  double largest{};
};

Extent extent_of(const nlohmann::json& instance) {
  Extent extent;
  for (const auto& item : instance.at("items")) {
    for (const auto& [x, y] : item.at("shape").at("data").get<Points>()) {
      for (const double value : {x, y}) {
        extent.decimals = std::max(extent.decimals, geometry::decimals_of(value));
        extent.largest = std::max(extent.largest, std::abs(value) * 4);
      }
    }
  }
  return extent;
}

Polygon outline_of(const nlohmann::json& item, Resolution resolution, const std::string& path) {
  Polygon corners;
  for (const auto& [x, y] : item.at("shape").at("data").get<Points>()) {
    corners.push_back({to_lattice(x, resolution), to_lattice(y, resolution)});
  }
  auto clean = geometry::clean_polygon(corners);
  if (!clean) fail(path, clean.error().message);
  return std::move(clean->polygon);
}

}  // namespace

Marker read_instance(const std::string& path, bool turns) {
  std::ifstream file{path};
  const auto instance = nlohmann::json::parse(file, nullptr, false);
  if (instance.is_discarded()) fail(path, "no JSON");
  const double width = instance.at("strip_height").get<double>();
  const Extent extent = extent_of(instance);
  Marker marker;
  marker.name = instance.value("name", path);
  marker.resolution = geometry::choose_resolution(extent.decimals, std::max(extent.largest, width * 16), width);
  marker.strip.width = to_lattice(width, marker.resolution);
  for (const auto& item : instance.at("items")) {
    const auto id = static_cast<std::uint32_t>(marker.shapes.size());
    Shape shape;
    shape.id = std::to_string(id);
    shape.outline = outline_of(item, marker.resolution, path);
    shape.rotations.clear();
    for (const double degrees : item.at("allowed_orientations").get<std::vector<double>>()) {
      if (turns || shape.rotations.empty()) shape.rotations.push_back(Angle::of_degrees(degrees));
    }
    for (int copy = 0; copy < item.at("demand").get<int>(); ++copy) {
      Piece piece;
      piece.id = shape.id + "." + std::to_string(copy);
      piece.shape = ShapeId{id};
      piece.orientation.rotation = shape.rotations.front();
      marker.pieces.push_back(std::move(piece));
    }
    marker.shapes.push_back(std::move(shape));
  }
  auto made = make_marker(std::move(marker));
  if (!made) fail(path, made.error().message);
  return *std::move(made);
}

}  // namespace selvage::bench
