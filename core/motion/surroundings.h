// What a piece may not enter near some place: the other pieces' Minkowski sums, and their borders within a window of
// positions.
#pragma once

#include <optional>
#include <vector>

#include "core/motion/border.h"
#include "core/motion/scene.h"

namespace selvage {

class Surroundings {
 public:
  // All that matters to the piece while its position stays inside `window`.  Real coordinates are relative to `origin`.
  Surroundings(const Scene& scene, std::uint32_t piece, const Box& window, Vec origin);

  [[nodiscard]] const std::vector<BorderLine>& lines() const { return lines_; }
  [[nodiscard]] std::size_t obstacles() const { return near_.size(); }
  // The lines of an obstacle are those from here up to where the next one's begin.
  [[nodiscard]] std::uint32_t first_line(std::size_t obstacle) const { return first_line_[obstacle]; }
  // True when the obstacle forbids the point; within a few units of its border either answer may come.
  [[nodiscard]] bool forbids(std::size_t obstacle, Real2 point) const;
  // Free of everything?  In integers, the strip aside.
  [[nodiscard]] bool free(Vec position) const;

 private:
  struct Near {
    std::uint32_t piece{};
    Obstacle obstacle;
  };
  void append_lines(const Near& near, const Box& window);
  [[nodiscard]] Real2 real(Vec position) const {
    return {static_cast<double>(position.x - origin_.x), static_cast<double>(position.y - origin_.y)};
  }

  const Scene& scene_;
  std::uint32_t piece_;
  Vec origin_;
  Coord spacing_;
  std::vector<Near> near_;
  std::vector<BorderLine> lines_;
  std::vector<std::uint32_t> first_line_;  // one more than obstacles
};

}  // namespace selvage
