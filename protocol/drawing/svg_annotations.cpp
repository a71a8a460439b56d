#include "protocol/drawing/svg_annotations.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/document/frame.h"

namespace selvage::protocol::drawing {
namespace {

using document::Spot;

constexpr double kLeastNotch = 3;      // pixels; shorter ones would be invisible
constexpr double kDrill = 1.6;         // the radius of a drill hole, pixels
constexpr double kSmallestText = 3.5;  // pixels

// From the marker's unit to pixels.
class Pen {
 public:
  Pen(const Marker& marker, const View& view) : unit_{to_decimal(1, marker.resolution)}, view_{view} {}
  [[nodiscard]] double x(const Spot& spot) const { return view_.x(spot.x / unit_); }
  [[nodiscard]] double y(const Spot& spot) const { return view_.y(spot.y / unit_); }
  [[nodiscard]] double length(double in_unit) const { return in_unit / unit_ * view_.scale(); }

 private:
  double unit_;
  const View& view_;
};

std::string notch_mark(const document::Notch& notch, const std::vector<Spot>& outline, const Pen& pen) {
  const double angle = direction_of(notch, outline) * std::numbers::pi / 180;
  const double depth = std::max(kLeastNotch, pen.length(notch.depth));
  const double x = pen.x(notch.at), y = pen.y(notch.at);
  return line(x, y, x + depth * std::cos(angle), y - depth * std::sin(angle), "notch");
}

std::string line_path(const document::DrawnLine& drawn, const Pen& pen) {
  std::string path;
  for (const Spot& point : drawn.points)
    path += (path.empty() ? "M" : "L") + pixels(pen.x(point)) + " " + pixels(pen.y(point));
  const std::string kind{document::kLineWords[static_cast<std::size_t>(drawn.kind)]};
  return "<path class=\"inner " + kind + "\" d=\"" + path + (drawn.closed ? "Z" : "") + "\"/>\n";
}

std::string text_mark(const document::DrawnText& text, const Pen& pen) {
  const double size = pen.length(text.height);
  if (size < kSmallestText) return "";
  const std::string x = pixels(pen.x(text.at)), y = pixels(pen.y(text.at));
  std::string out = "<text class=\"remark\" font-size=\"" + pixels(size) + "\" x=\"" + x + "\" y=\"" + y + "\"";
  if (text.angle != 0) out += " transform=\"rotate(" + pixels(-text.angle) + " " + x + " " + y + ")\"";
  return out + ">" + escaped(text.text) + "</text>\n";
}

}  // namespace

std::string annotations(const document::Annotations& annotations, const Marker& marker, const Piece& piece,
                        const Polygon& outline, const View& view) {
  const auto decimal = [&](Coord coord) { return to_decimal(coord, marker.resolution); };
  const Orientation& o = piece.orientation;
  const document::Annotations here = document::placed(
      annotations, {o.flip, o.rotation.degrees + o.tilt.degrees, {decimal(piece.at.x), decimal(piece.at.y)}});
  std::vector<Spot> boundary;
  for (const Vec vertex : outline) boundary.push_back({decimal(vertex.x), decimal(vertex.y)});
  const Pen pen{marker, view};
  std::string out;
  for (const document::DrawnLine& drawn : here.lines) out += line_path(drawn, pen);
  for (const document::Notch& notch : here.notches) out += notch_mark(notch, boundary, pen);
  for (const Spot& drill : here.drills) {
    out += "<circle class=\"drill\" cx=\"" + pixels(pen.x(drill)) + "\" cy=\"" + pixels(pen.y(drill)) + "\" r=\"" +
           pixels(kDrill) + "\"/>\n";
  }
  for (const document::DrawnText& text : here.texts) out += text_mark(text, pen);
  return out;
}

}  // namespace selvage::protocol::drawing
