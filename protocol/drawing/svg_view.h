// The drawing's page: where the strip lies on it, how lattice units become pixels, and the few elements it is made of.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "core/geometry/lattice.h"

namespace selvage::protocol::drawing {

// From lattice units to pixels.
class View {
 public:
  static constexpr double kLeft = 46, kRight = 70, kTop = 52, kBottom = 40;  // margins round the strip, in pixels

  // `length` and `end`: where the marker and the drawn cloth end, lattice units; `height`: of the strip, in pixels.
  View(Coord width, Coord length, Coord end, double height)
      : scale_{height / static_cast<double>(std::max<Coord>(1, width))},
        length_{static_cast<double>(length)},
        end_{static_cast<double>(end)},
        height_{height} {}

  [[nodiscard]] double x(double lattice) const { return kLeft + lattice * scale_; }
  [[nodiscard]] double y(double lattice) const { return kTop + height_ - lattice * scale_; }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double end() const { return end_; }  // where the drawn cloth ends
  [[nodiscard]] double bottom() const { return kTop + height_; }
  [[nodiscard]] double width() const { return std::max(x(end_) + kRight, 560.0); }
  [[nodiscard]] double height() const { return kTop + height_ + kBottom; }

 private:
  double scale_, length_, end_, height_;
};

// So many decimals; and rounded to a hundredth, as short as can be.
[[nodiscard]] std::string fixed(double value, int decimals);
[[nodiscard]] std::string pixels(double value);
// Text that may stand in an element or an attribute.
[[nodiscard]] std::string escaped(std::string_view text);

// In pixels; `style` is a class of the drawing's style sheet.
[[nodiscard]] std::string line(double x1, double y1, double x2, double y2, std::string_view style);
[[nodiscard]] std::string text_at(double x, double y, std::string_view style, std::string_view text);

}  // namespace selvage::protocol::drawing
