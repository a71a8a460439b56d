#include "protocol/document/frame.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace selvage::protocol::document {
namespace {

double in_one_turn(double degrees) {
  const double turned = std::fmod(degrees, 360.0);
  return turned < 0 ? turned + 360 : turned + 0.0;
}

double squared_distance(Spot p, Spot a, Spot b) {
  const Spot ab{b.x - a.x, b.y - a.y}, ap{p.x - a.x, p.y - a.y};
  const double length = ab.x * ab.x + ab.y * ab.y;
  const double t = length > 0 ? std::clamp((ap.x * ab.x + ap.y * ab.y) / length, 0.0, 1.0) : 0;
  return std::pow(ap.x - t * ab.x, 2) + std::pow(ap.y - t * ab.y, 2);
}

}  // namespace

Frame::Frame(bool flip, double degrees, Spot at) : flip_{flip}, degrees_{in_one_turn(degrees)}, at_{at} {
  const double quarters = degrees_ / 90;
  if (quarters == std::floor(quarters)) {
    constexpr double kSines[] = {0, 1, 0, -1, 0};
    sine_ = kSines[static_cast<int>(quarters) % 4];
    cosine_ = kSines[static_cast<int>(quarters) % 4 + 1];
  } else {
    sine_ = std::sin(degrees_ * std::numbers::pi / 180);
    cosine_ = std::cos(degrees_ * std::numbers::pi / 180);
  }
}

Frame reflection(Spot a, Spot b) {
  const double degrees = 2 * std::atan2(b.y - a.y, b.x - a.x) * 180 / std::numbers::pi;
  const Spot image = Frame{true, degrees, {}}.apply(a);
  return {true, degrees, {a.x - image.x, a.y - image.y}};
}

Annotations placed(const Annotations& annotations, const Frame& frame) {
  Annotations out = annotations;
  for (Notch& notch : out.notches) {
    notch.at = frame.apply(notch.at);
    if (notch.angle) notch.angle = in_one_turn(frame.angle(*notch.angle));
  }
  for (Spot& drill : out.drills) drill = frame.apply(drill);
  for (DrawnLine& line : out.lines) {
    for (Spot& point : line.points) point = frame.apply(point);
  }
  for (DrawnText& text : out.texts) {
    text.at = frame.apply(text.at);
    text.angle = in_one_turn(frame.angle(text.angle));
  }
  return out;
}

double direction_of(const Notch& notch, const std::vector<Spot>& outline) {
  if (notch.angle || outline.empty()) return notch.angle.value_or(0);
  double nearest = std::numeric_limits<double>::infinity(), degrees = 0;
  for (std::size_t k = 0; k < outline.size(); ++k) {
    const Spot a = outline[k], b = outline[(k + 1) % outline.size()];
    const double away = squared_distance(notch.at, a, b);
    if (away >= nearest) continue;
    nearest = away;
    degrees = std::atan2(b.x - a.x, -(b.y - a.y)) * 180 / std::numbers::pi;  // to the left of the edge
  }
  return in_one_turn(degrees);
}

}  // namespace selvage::protocol::document
