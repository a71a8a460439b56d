#include "tests/core/motion/compaction/hard_instances.h"

#include <algorithm>
#include <cmath>

#include "tests/core/motion/markers.h"

namespace selvage::test {
namespace {

struct Point {
  double x{}, y{};
};
using Outline = std::vector<Point>;

// A marker built piece by piece in units of the construction, at any position along x.
class Drawing {
 public:
  void draw(const Outline& outline, bool locked = false) { drawn_.push_back({outline, locked}); }
  void draw_box(Point low, Point high, bool locked = false) {
    draw({low, {high.x, low.y}, high, {low.x, high.y}}, locked);
  }
  // Returns the marker, moved so that its left end is `room` away from the strip's.
  [[nodiscard]] Marker marker(double width, double room = 0) const {
    double left = drawn_.front().outline.front().x;
    for (const Drawn& piece : drawn_) {
      for (const Point& p : piece.outline) left = std::min(left, p.x);
    }
    Layout layout{in_units(width)};
    for (const Drawn& piece : drawn_) {
      Polygon polygon;
      for (const Point& p : piece.outline) polygon.push_back({in_units(p.x), in_units(p.y)});
      layout.put(layout.shape_of(clean_polygon(polygon)->polygon), {in_units(room - left), 0}, 0, piece.locked);
    }
    return layout.marker();
  }

 private:
  struct Drawn {
    Outline outline;
    bool locked{};
  };
  static Coord in_units(double x) { return std::llround(x * static_cast<double>(kUnit)); }
  std::vector<Drawn> drawn_;
};

// One group of the propagation device.  y: the channel's valleys are at 1, its tips at 2, the slides' middle at 4.5.
class Group {
 public:
  // `follower`: where the follower begins, in the rightmost valley.
  Group(int k, double follower) : k_{k}, follower_{follower} {}

  void draw(Drawing& drawing) const {
    draw_channel(drawing);
    draw_follower(drawing);
    draw_lifter(drawing);
  }
  // The slide of the first group, with rails that fix its height; its right end can move in by k.
  void draw_first_slide(Drawing& drawing) const {
    draw_rails(drawing, follower_ + 1.2);
    const double end = follower_ + 2.6 + k_;
    drawing.draw({{head_left(), kMiddle - 1},
                  {stem_left(), kMiddle - 1},
                  {stem_left(), kMiddle - 0.15},
                  {end, kMiddle - 0.15},
                  {end, kMiddle + 0.15},
                  {stem_left(), kMiddle + 0.15},
                  {stem_left(), kMiddle + 1},
                  {head_left(), kMiddle + 1}});
  }
  // The slide that this group's lifter drives, and the point where the next group's follower is attached to it.
  [[nodiscard]] double next_follower() const { return lifter_left() - k_ - 3.6; }
  void draw_driven_slide(Drawing& drawing, bool last) const {
    draw_rails(drawing, lifter_left() - k_ - 2.2);
    const double tail = lifter_left() - 0.2;  // where the slanted bar begins
    const double tip = lifter_left() + k_ + 1;
    Outline slide{{tail, bar_low(tail)},
                  {tip, bar_low(tip)},
                  {tip, bar_low(tip) + 0.5},
                  {tail, bar_low(tail) + 0.5},
                  {tail - 0.4, bar_low(tail) + 0.5},
                  {tail - 0.4, kMiddle + 0.15}};
    const Group next{k_, next_follower()};
    const double stem = last ? next.follower_ + 1 : next.stem_left();
    slide.push_back({stem, kMiddle + 0.15});
    if (!last) {
      for (const Point p : {Point{next.stem_left(), kMiddle + 1},
                            {next.head_left(), kMiddle + 1},
                            {next.head_left(), kMiddle - 1},
                            {next.stem_left(), kMiddle - 1}}) {
        slide.push_back(p);
      }
    }
    slide.push_back({stem, kMiddle - 0.15});
    slide.push_back({tail, kMiddle - 0.15});
    drawing.draw(slide);
  }

 private:
  static constexpr double kClearance = 0.02;
  static constexpr double kMiddle = 4.5;  // of the slides
  static constexpr double kHeight = 6;    // of the follower

  [[nodiscard]] double head_left() const { return follower_ + 0.25 + kClearance; }
  [[nodiscard]] double stem_left() const { return follower_ + 0.65 - kClearance; }
  [[nodiscard]] double lifter_right() const { return follower_ - k_ - 1.5; }
  [[nodiscard]] double lifter_left() const { return lifter_right() - k_ - 2; }
  [[nodiscard]] double bar_low(double x) const { return 5.2 + (x - lifter_left()) / k_; }

  void draw_channel(Drawing& drawing) const {
    const double left = follower_ - k_ - 0.5;
    const double right = follower_ + 0.5;
    Outline below{{left, 0}, {right, 0}};
    Outline above{{right, 11}, {left, 11}};
    for (int j = 0; j <= 2 * k_ + 2; ++j) below.push_back({right - 0.5 * j, j % 2 == 0 ? 2.0 : 1.0});
    for (int j = 0; j <= 2 * k_ + 2; ++j) {
      above.push_back({left + 0.5 * j, (j % 2 == 0 ? 2.0 : 1.0) + kHeight + kClearance});
    }
    drawing.draw(below, true);
    drawing.draw(above, true);
  }
  // A bar with a point at either end, a bracket to the right for the slide's head, an arm to the left.
  void draw_follower(Drawing& drawing) const {
    const double arm = -k_ - 2.0;
    Outline follower{{0, 0},       {0.25, 1.2},   {0.95, 1.2}, {0.95, 2.3}, {0.65, 2.3},   {0.65, 1.4}, {0.25, 1.4},
                     {0.25, 4.6},  {0.65, 4.6},   {0.65, 3.7}, {0.95, 3.7}, {0.95, 4.8},   {0.25, 4.8}, {0, kHeight},
                     {-0.25, 4.8}, {-0.25, 3.25}, {arm, 3.25}, {arm, 2.75}, {-0.25, 2.75}, {-0.25, 1.2}};
    for (Point& p : follower) p = {p.x + follower_, p.y + 1 + kClearance / 2};
    drawing.draw(follower);
  }
  // A block with a level slot for the follower's arm and a slanted one for the next slide, between two rails.
  void draw_lifter(Drawing& drawing) const {
    const double l = lifter_left();
    const double r = lifter_right();
    const double arm = 4 + kClearance / 2;
    const double deep = l + k_ + 1.2;
    drawing.draw({{l, 1.5},
                  {r, 1.5},
                  {r, arm - 0.25 - kClearance},
                  {r - k_ - 0.6, arm - 0.25 - kClearance},
                  {r - k_ - 0.6, arm + 0.25 + kClearance},
                  {r, arm + 0.25 + kClearance},
                  {r, 8},
                  {l, 8},
                  {l, bar_low(l) + 0.5 + kClearance},
                  {deep, bar_low(deep) + 0.5 + kClearance},
                  {deep, bar_low(deep) - kClearance},
                  {l, bar_low(l) - kClearance}});
    drawing.draw_box({r + kClearance, 5.5}, {r + 0.8, 7.5}, true);
    drawing.draw_box({l - 0.8, 2.5}, {l - kClearance, 4.0}, true);
  }
  static void draw_rails(Drawing& drawing, double left) {
    drawing.draw_box({left, kMiddle + 0.15 + kClearance}, {left + 1, kMiddle + 1.15}, true);
    drawing.draw_box({left, kMiddle - 1.15}, {left + 1, kMiddle - 0.15 - kClearance}, true);
  }

  int k_;
  double follower_;
};

}  // namespace

Marker partition(const std::vector<int>& lengths) {
  Drawing drawing;
  double x = 0;
  double y = 0;
  for (const int length : lengths) {
    drawing.draw_box({x, y}, {x + length, y + 1});
    x += length;
    y = 1 - y;
  }
  return drawing.marker(2);
}

Marker u_shapes_and_bars(int n) {
  Drawing drawing;
  const double slot = 2.0 * n;
  for (int s = 0; s < 3; ++s) {  // blocks, and the bar to the right of each slot but the last
    const double left = s * (slot + 1);
    if (s == 0) drawing.draw_box({left, 0}, {left + slot, slot});
    for (int half = 0; s > 0 && half < 2; ++half) drawing.draw_box({left + half * n, 0}, {left + (half + 1) * n, slot});
    if (s < 2) drawing.draw_box({left + slot, 0}, {left + slot + 1, 3.0 * n + 1});
  }
  const double left = 2 * (slot + 1);
  for (int i = 1; i <= n; ++i) {  // each stands in the one before
    const double low = slot + i - 1;
    const double l = left + i - 1;
    const double r = left + slot - i + 1;
    const double high = low + n;
    if (i == n) {
      drawing.draw_box({l, low}, {r, high});  // nothing is left of its inside
    } else {
      drawing.draw(
          {{l, low}, {r, low}, {r, high}, {r - 1, high}, {r - 1, low + 1}, {l + 1, low + 1}, {l + 1, high}, {l, high}});
    }
  }
  return drawing.marker(4.0 * n + 2);
}

Marker motion_propagation(int n, int k) {
  Drawing drawing;
  Group group{k, 0};
  group.draw_first_slide(drawing);
  for (int g = 1;; ++g) {
    group.draw(drawing);
    group.draw_driven_slide(drawing, g == n);
    if (g == n) break;
    group = Group{k, group.next_follower()};
  }
  return drawing.marker(11.5, k + 1);
}

}  // namespace selvage::test
