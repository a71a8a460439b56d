// The garment markers of examples/markers, by name.
#pragma once

#include <string>

#include "bench/support/marker_file.h"

namespace selvage::bench {

inline std::string path_of_example(const std::string& name) {
  return std::string{SELVAGE_SOURCE_DIR} + "/examples/markers/" + name + ".json";
}

inline Marker example_marker(const std::string& name) {
  return marker_in(path_of_example(name));
}

}  // namespace selvage::bench
