// Reading marker files in benchmarks and tables.  A file that cannot be read ends the program with the reason.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "protocol/formats/format.h"

namespace selvage::bench {

inline MarkerFile marker_file_in(const std::string& path) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  auto read = protocol::formats::read_marker(text.str());
  if (read) return *std::move(read);
  std::fprintf(stderr, "%s: %s\n", path.c_str(), read.error().message.c_str());
  std::exit(EXIT_FAILURE);
}

inline Marker marker_in(const std::string& path) {
  return marker_file_in(path).marker;
}

inline std::string name_of(const std::string& path) {
  return std::filesystem::path{path}.stem().string();
}

// False when the file cannot be written.
inline bool write_marker(const std::string& path, const Marker& marker, Format format) {
  MarkerFile file{.marker = marker, .format = Format::kNative, .notes = {}, .attributes = {}};
  file.attributes.shapes.assign(marker.shapes.size(), Json::object());
  file.attributes.pieces.assign(marker.pieces.size(), Json::object());
  file.attributes.unplaced.assign(marker.unplaced.size(), Json::object());
  const auto document = protocol::formats::marker_document(file, format);
  std::ofstream out{path};
  if (document) out << protocol::json::to_text(*document) << "\n";
  return document && out.good();
}

// Writes the marker as placed outlines for an independent judge.  False when the file cannot be written.
inline bool write_outlines(const std::string& path, const Marker& marker) {
  return write_marker(path, marker, Format::kOutlines);
}

}  // namespace selvage::bench
