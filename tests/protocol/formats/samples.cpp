#include "tests/protocol/formats/samples.h"

#include <gtest/gtest.h>

#include "protocol/json/fields.h"

namespace selvage::test {

Json json(const std::string& text) {
  auto parsed = protocol::json::parse(text);
  if (!parsed) throw std::runtime_error{protocol::json::describe(parsed.error()) + " in " + text};
  return *std::move(parsed);
}

MarkerFile read(const Json& document) {
  auto file = protocol::formats::read_document(document);
  if (!file) throw std::runtime_error{protocol::json::describe(file.error())};
  return *std::move(file);
}

Json native_squares() {
  return json(R"({
    "format": "selvage-marker", "version": 1, "name": "two squares", "strip": {"width": 100},
    "shapes": [{"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}],
    "pieces": [{"id": "left", "shape": "square", "at": [0, 0]}, {"id": "right", "shape": "square", "at": [50, 10]}]
  })");
}

Json sparrow_squares() {
  return json(R"({
    "name": "two squares",
    "items": [{"id": 7, "demand": 2, "allowed_orientations": [0, 180],
               "shape": {"type": "simple_polygon", "data": [[0, 0], [40, 0], [40, 40], [0, 40], [0, 0]]}}],
    "strip_height": 100,
    "solution": {"strip_width": 90, "density": 0.3, "run_time_sec": 12, "layout": {"container_id": 0, "density": 0.3,
      "placed_items": [{"item_id": 7, "transformation": {"rotation": 0, "translation": [0, 0]}},
                       {"item_id": 7, "transformation": {"rotation": 0, "translation": [50, 10]}}]}}
  })");
}

}  // namespace selvage::test
