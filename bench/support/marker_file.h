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

inline Marker marker_in(const std::string& path) {
  std::ifstream in{path};
  std::stringstream text;
  text << in.rdbuf();
  const auto read = protocol::formats::read_marker(text.str());
  if (read) return read->marker;
  std::fprintf(stderr, "%s: %s\n", path.c_str(), read.error().message.c_str());
  std::exit(EXIT_FAILURE);
}

inline std::string name_of(const std::string& path) {
  return std::filesystem::path{path}.stem().string();
}

// Writes the marker as placed outlines for an independent judge.  False when the file cannot be written.
inline bool write_outlines(const std::string& path, const Marker& marker) {
  MarkerFile file{.marker = marker, .format = Format::kNative, .notes = {}, .attributes = {}};
  std::ofstream out{path};
  out << protocol::json::to_text(*protocol::formats::marker_document(file, Format::kOutlines)) << "\n";
  return out.good();
}

}  // namespace selvage::bench
