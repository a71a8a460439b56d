#include "protocol/drawing/svg_view.h"

#include <array>
#include <charconv>
#include <cmath>

#include "protocol/document/xml_text.h"

namespace selvage::protocol::drawing {
namespace {

constexpr double kLongestRow = 6;  // times the strip's width
constexpr double kMostRows = 100;  // a strip that would need more rows is drawn at a smaller scale
constexpr double kBetween = 24;    // pixels between the ruler of a row and the cloth of the next

}  // namespace

Rows::Rows(Coord width, Coord length, Coord end, double height)
    : scale_{height / static_cast<double>(std::max<Coord>(1, width))},
      length_{static_cast<double>(length)},
      end_{static_cast<double>(end)},
      height_{height} {
  const double longest = kLongestRow * height;  // pixels
  const double rows = end_ * scale_ / longest;
  if (rows > kMostRows) {
    scale_ *= kMostRows / rows;
    height_ *= kMostRows / rows;
  }
  count_ = static_cast<std::size_t>(std::clamp(std::ceil(rows), 1.0, kMostRows));
}

View Rows::row(std::size_t index) const {
  const double each = end_ / static_cast<double>(count_), number = static_cast<double>(index);
  View view;
  view.scale_ = scale_;
  view.length_ = length_;
  view.end_ = end_;
  view.height_ = height_;
  view.from_ = number * each;
  view.to_ = index + 1 == count_ ? end_ : (number + 1) * each;
  view.top_ = View::kTop + number * (height_ + View::kBottom + kBetween);
  return view;
}

std::string fixed(double value, int decimals) {
  std::array<char, 64> buffer{};
  const auto result =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
  return {buffer.data(), result.ptr};
}

std::string pixels(double value) {
  std::string text = fixed(value, 2);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : document::xml_text(text)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

double text_width(std::string_view text, double size) {
  constexpr double kCharacterWidth = 0.56;
  const auto characters =
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
  return size * kCharacterWidth * static_cast<double>(characters);
}

std::string line(double x1, double y1, double x2, double y2, std::string_view style) {
  return "<line x1=\"" + pixels(x1) + "\" y1=\"" + pixels(y1) + "\" x2=\"" + pixels(x2) + "\" y2=\"" + pixels(y2) +
         "\" class=\"" + std::string{style} + "\"/>\n";
}

std::string text_at(double x, double y, std::string_view style, std::string_view text) {
  return "<text x=\"" + pixels(x) + "\" y=\"" + pixels(y) + "\" class=\"" + std::string{style} + "\">" + escaped(text) +
         "</text>\n";
}

std::string outline_path(const Polygon& outline, const View& view) {
  std::string path;
  for (const Vec v : outline) {
    path += path.empty() ? "M" : "L";
    path += pixels(view.x(static_cast<double>(v.x))) + " " + pixels(view.y(static_cast<double>(v.y)));
  }
  return path + "Z";
}

std::string clipped(double x, double y, double width, double height, const std::string& drawn) {
  const std::string at_x = pixels(x), at_y = pixels(y), across = pixels(width), down = pixels(height);
  return "<svg x=\"" + at_x + "\" y=\"" + at_y + "\" width=\"" + across + "\" height=\"" + down + "\" viewBox=\"" +
         at_x + " " + at_y + " " + across + " " + down + "\">\n" + drawn + "</svg>\n";
}

}  // namespace selvage::protocol::drawing
