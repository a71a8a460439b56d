// The positions that are forbidden to a piece, and to all pieces tied to it, near some position: the Minkowski sums
// with the other pieces, and their borders within a window of positions.
#pragma once

#include <stop_token>
#include <vector>

#include "core/motion/placing/border.h"
#include "core/scene/scene.h"

namespace selvage::motion::placing {

// A piece and those that move with it.
struct Body {
  struct Member {
    std::uint32_t piece{};
    Vec offset;  // from the piece that the body is named after
  };
  Body(const scene::Scene& scene, PieceId piece);
  // The positions of the naming piece that keep the body within the strip up to `end` and respect its locks.
  [[nodiscard]] Box fit(const scene::Scene& scene, Coord end) const;
  [[nodiscard]] bool holds(std::uint32_t piece) const { return moving[piece]; }
  std::vector<Member> members;
  std::vector<bool> moving;  // by piece: the members
  Vec at;                    // of the naming piece
  bool fixed_x{}, fixed_y{};
};

class Surroundings {
 public:
  // All obstacles that matter while the body's position stays inside `window`.  Real coordinates are relative to
  // `origin`.
  Surroundings(const scene::Scene& scene, const Body& body, const Box& window, Vec origin, const std::stop_token& stop);

  // False when cancelled: obstacles are missing.
  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] const std::vector<BorderLine>& lines() const { return lines_; }
  [[nodiscard]] std::size_t obstacles() const { return near_.size(); }
  // The index of an obstacle's first line; its last one comes just before the first line of the next obstacle.
  [[nodiscard]] std::uint32_t first_line(std::size_t obstacle) const { return first_line_[obstacle]; }
  // True when the obstacle forbids the point; within a few units of the border either answer is possible.
  [[nodiscard]] bool forbids(std::size_t obstacle, RealVec point) const;
  // True when the position is free of all obstacles, exactly; the strip is not considered.
  [[nodiscard]] bool free(Vec position) const;

 private:
  struct Near {
    std::uint32_t member{}, other{};
    Vec offset;  // of the member
    Coord spacing{};
    minkowski::Obstacle obstacle;
  };
  void append_near(const Body& body, const Body::Member& member, const Box& window, const std::stop_token& stop);
  void append_lines(const Near& near, const Box& window);
  [[nodiscard]] RealVec real(Vec position) const {
    return {static_cast<double>(position.x - origin_.x), static_cast<double>(position.y - origin_.y)};
  }

  const scene::Scene& scene_;
  Vec origin_;
  std::vector<Near> near_;
  std::vector<BorderLine> lines_;
  std::vector<std::uint32_t> first_line_;  // one more than obstacles
  bool complete_{true};
};

}  // namespace selvage::motion::placing
