// A drawing of the best marker so far, for a viewer that reloads its file while nesting continues.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <utility>

#include "core/marker/marker.h"

namespace selvage::cli::commands {

class LivePicture {
 public:
  explicit LivePicture(std::string path) : path_{std::move(path)} {}

  // Draws the marker, unless less than a second has passed since the last one.  The viewer finds a whole drawing at any
  // time.  A file that cannot be written is no reason to stop: it is reported when the result is written.
  void show(const Marker& marker);

 private:
  std::string path_;
  std::optional<std::chrono::steady_clock::time_point> drawn_;
};

}  // namespace selvage::cli::commands
