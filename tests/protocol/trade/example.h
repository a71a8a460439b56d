// Files of examples/trade, and the real ones in the folder that SELVAGE_TRADE_DATA names.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>

#include "core/geometry/lattice.h"
#include "protocol/files/reading.h"
#include "tests/support/repository.h"

namespace selvage::test {

inline std::string example(const std::string& name) {
  return repository_text("examples/trade/" + name);
}

// Empty when the folder is not there.
inline std::string real_file(const std::string& name) {
  const char* folder = std::getenv("SELVAGE_TRADE_DATA");
  if (!folder) return {};
  std::ifstream file{std::string{folder} + "/" + name, std::ios::binary};
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

// REQUIRES: the file can be read.
inline MarkerFile read_example(const std::string& name, const protocol::trade::ReadingOptions& options = {}) {
  auto file = protocol::files::read_file(example(name), options);
  if (!file) throw std::runtime_error(name + ": " + file.error().field + ": " + file.error().message);
  return *std::move(file);
}

// REQUIRES: the text can be read.
inline MarkerFile read_text(const std::string& text, const protocol::trade::ReadingOptions& options = {}) {
  auto file = protocol::files::read_file(text, options);
  if (!file) throw std::runtime_error(file.error().field + ": " + file.error().message);
  return *std::move(file);
}

inline bool has_note(const MarkerFile& file, const std::string& text) {
  for (const Note& note : file.notes) {
    if ((note.field + ": " + note.text).find(text) != std::string::npos) return true;
  }
  return false;
}

// The size of a shape's box, in the marker's unit.
struct Extent {
  double x{}, y{};
};
inline Extent extent_of(const MarkerFile& file, const std::string& shape) {
  for (const Shape& one : file.marker.shapes) {
    if (one.id != shape) continue;
    const Box box = box_of(one.outline);
    return {to_decimal(box.width(), file.marker.resolution), to_decimal(box.height(), file.marker.resolution)};
  }
  ADD_FAILURE() << "no shape " << shape;
  return {};
}

// In the marker's unit, squared.
inline double area_of(const MarkerFile& file, std::size_t shape) {
  const double unit = to_decimal(1, file.marker.resolution);
  return static_cast<double>(geometry::doubled_area(file.marker.shapes[shape].outline)) / 2 * unit * unit;
}

inline std::size_t pieces_of(const MarkerFile& file, const std::string& shape) {
  std::size_t count = 0;
  for (const Piece& piece : file.marker.pieces) count += file.marker.shapes[piece.shape.value].id == shape;
  return count;
}

}  // namespace selvage::test
