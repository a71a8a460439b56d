#include "protocol/trade/dxf/strokes/insertion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "protocol/json/json_text.h"
#include "protocol/trade/style.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf::strokes {

using document::Spot;

void Insertion::apply(Run& run) const {
  for (Spot& point : run.points) point = apply(point);
  for (Edge& edge : run.edges) {
    if (edge.apex) edge.apex = apply(*edge.apex);
  }
}

double Insertion::apply_to_angle(double degrees) const {
  if (xx == 1 && yy == 1 && xy == 0 && yx == 0) return degrees;  // exactly
  const double c = std::cos(degrees * std::numbers::pi / 180), s = std::sin(degrees * std::numbers::pi / 180);
  return std::atan2(yx * c + yy * s, xx * c + xy * s) * 180 / std::numbers::pi;
}

Insertion Insertion::after(const Insertion& inner) const {
  return {xx * inner.xx + xy * inner.yx, xx * inner.xy + xy * inner.yy, yx * inner.xx + yy * inner.yx,
          yx * inner.xy + yy * inner.yy, apply(inner.at)};
}

double Insertion::scale() const {
  if (!scales_evenly()) return std::sqrt(std::abs(xx * yy - xy * yx));
  const double length = std::hypot(xx, yx);
  return std::abs(length - 1) <= 1e-9 ? 1 : length;  // a rotation rounds it
}

bool Insertion::scales_evenly() const {
  const double x = std::hypot(xx, yx), y = std::hypot(xy, yy);
  return std::abs(x - y) <= 1e-6 * x && std::abs(xx * xy + yx * yy) <= 1e-6 * x * y;
}

bool from_behind(const Entity& entity) {
  return entity.number(230).value_or(1) < 0 && entity.type != "LINE" && entity.type != "SPLINE" &&
         entity.type != "ELLIPSE" && entity.type != "POINT";
}

Insertion insertion_of(const Entity& insert, const Block& block, int column, int row) {
  const double sx = insert.number(41).value_or(1), sy = insert.number(42).value_or(1);
  const double degrees = insert.number(50).value_or(0), angle = degrees * std::numbers::pi / 180;
  double c = std::cos(angle), s = std::sin(angle);
  if (const double turn = std::fmod(degrees, 360); std::fmod(turn, 90) == 0) {  // exactly
    const int quarters = (static_cast<int>(turn / 90) + 4) % 4;
    c = quarters == 0 ? 1 : quarters == 2 ? -1 : 0;
    s = quarters == 1 ? 1 : quarters == 3 ? -1 : 0;
  }
  const Spot at = insert.vertices.empty() ? Spot{} : Spot{insert.vertices.front().x, insert.vertices.front().y};
  const Spot step{column * insert.number(44).value_or(0), row * insert.number(45).value_or(0)};
  Insertion placed{c * sx, -s * sy, s * sx, c * sy, {at.x + c * step.x - s * step.y, at.y + s * step.x + c * step.y}};
  placed.at = placed.apply({-block.base_x, -block.base_y});
  return placed;
}

Blocks::Blocks(const DxfDrawing& drawing) {
  for (const Block& block : drawing.blocks) {
    by_name_.emplace(block.name, &block);
    by_capitals_.emplace(in_capitals(block.name), &block);
  }
}

const Block* Blocks::of(const Entity& insert) const {
  const std::string_view name = insert.text(2);
  if (const auto exact = by_name_.find(name); exact != by_name_.end()) return exact->second;
  const auto found = by_capitals_.find(in_capitals(name));
  return found == by_capitals_.end() ? nullptr : found->second;
}

// Scales of scales may be so large that coordinates are no longer finite.
bool Blocks::reaches(const Insertion& insertion, const Entity& insert) {
  constexpr double kLargest = 1e12;
  for (const double one : {insertion.xx, insertion.xy, insertion.yx, insertion.yy, insertion.at.x, insertion.at.y}) {
    if (!error_ && !(std::abs(one) <= kLargest)) {
      error_ = error_at(insert.line, ErrorCode::kOutOfRange,
                        "INSERT of block " + json::shortened(Json(printable(insert.text(2)))) +
                            ": it scales or moves by " + json::number_text(one) + "; at most 1e12 is allowed");
    }
  }
  return !error_;
}

bool Blocks::take(std::size_t count, const Entity& insert, int depth) {
  constexpr std::size_t kMostInserted = 500'000;
  inserted_ += count;
  if (!error_ && (depth >= kDeepestBlocks || inserted_ > kMostInserted)) {
    error_ = error_at(insert.line, ErrorCode::kOutOfRange,
                      "INSERT of block " + json::shortened(Json(printable(insert.text(2)))) +
                          ": blocks are nested more than 16 deep, or insert more than 500,000 entities and points");
  }
  return !error_;
}

int Blocks::steps(const Entity& insert, int code) {
  constexpr double kMostSteps = 1000;
  return static_cast<int>(std::clamp(insert.number(code).value_or(1), 1.0, kMostSteps));
}

}  // namespace selvage::protocol::trade::dxf::strokes
