// The page of a drawing: where the strip lies, how lattice units are mapped to pixels, and the SVG elements in use.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

#include "core/geometry/lattice.h"
#include "core/geometry/polygon.h"

namespace selvage::protocol::drawing {

// Maps lattice units to pixels in one row of a drawing, which shows the part of the strip between two x coordinates.
class View {
 public:
  static constexpr double kLeft = 46, kRight = 70, kTop = 52, kBottom = 40;  // margins round the strip, in pixels

  [[nodiscard]] double x(double lattice) const { return kLeft + (lattice - from_) * scale_; }
  [[nodiscard]] double y(double lattice) const { return bottom() - lattice * scale_; }
  [[nodiscard]] double scale() const { return scale_; }
  [[nodiscard]] double length() const { return length_; }  // where the marker ends
  [[nodiscard]] double end() const { return end_; }        // where the drawn cloth ends
  [[nodiscard]] double from() const { return from_; }
  [[nodiscard]] double to() const { return to_; }
  [[nodiscard]] double top() const { return top_; }
  [[nodiscard]] double bottom() const { return top_ + height_; }
  // True if a part of the box may lie in this row.
  [[nodiscard]] bool shows(const Box& box) const {
    return static_cast<double>(box.high.x) >= from_ && static_cast<double>(box.low.x) <= to_;
  }
  [[nodiscard]] bool is_first() const { return from_ <= 0; }
  [[nodiscard]] bool is_last() const { return to_ >= end_; }

 private:
  friend class Rows;
  View() = default;

  double scale_{}, length_{}, end_{}, height_{};
  double from_{}, to_{}, top_{};
};

// The rows of a drawing.  A strip that is much longer than wide would be unreadable in one row, so it is folded into
// rows of the same length, one below the other.  If it needed more than a hundred rows, it is drawn at a smaller scale.
class Rows {
 public:
  // `length` and `end`: where the marker and the drawn cloth end, lattice units; `height`: of the strip, in pixels, if
  // it is not too long.
  Rows(Coord width, Coord length, Coord end, double height);

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] View row(std::size_t index) const;
  // Of the page, in pixels.
  [[nodiscard]] double width() const { return std::max(row(0).x(row(0).to()) + View::kRight, 560.0); }
  [[nodiscard]] double height() const { return row(count_ - 1).bottom() + View::kBottom; }

 private:
  double scale_, length_, end_, height_;
  std::size_t count_{};
};

// With this number of decimals; and rounded to a hundredth, as short as possible.
[[nodiscard]] std::string fixed(double value, int decimals);
[[nodiscard]] std::string pixels(double value);
// Escapes text for use in an element or an attribute, with a blank for each character that XML does not have.
[[nodiscard]] std::string escaped(std::string_view text);

// The approximate width of a text, in units of the font's size.
[[nodiscard]] double text_width(std::string_view text, double size);

// The outline as the attribute `d` of a path.
[[nodiscard]] std::string outline_path(const Polygon& outline, const View& view);
// Clips the drawing to a rectangle of the page.
[[nodiscard]] std::string clipped(double x, double y, double width, double height, const std::string& drawn);
// In pixels; `style` is a class of the drawing's style sheet.
[[nodiscard]] std::string line(double x1, double y1, double x2, double y2, std::string_view style);
[[nodiscard]] std::string text_at(double x, double y, std::string_view style, std::string_view text);

}  // namespace selvage::protocol::drawing
