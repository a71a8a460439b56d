#include "protocol/trade/hpgl/user_units.h"

#include <algorithm>
#include <cmath>

#include "protocol/json/json_text.h"

namespace selvage::protocol::trade::hpgl {

using document::Spot;

void UserUnits::set_points(const std::vector<double>& numbers) {
  if (numbers.size() >= 4)
    points_ = {Spot{numbers[0], numbers[1]}, Spot{numbers[2], numbers[3]}};
  else if (numbers.size() >= 2 && points_)  // P2 follows P1
    points_ = {Spot{numbers[0], numbers[1]},
               Spot{numbers[0] + (*points_)[1].x - (*points_)[0].x, numbers[1] + (*points_)[1].y - (*points_)[0].y}};
  else
    points_.reset();
  settle();
}

std::optional<std::string> UserUnits::set_scale(const std::vector<double>& numbers) {
  constexpr std::size_t kLeast = 4;
  scale_.reset();
  map_.reset();
  if (numbers.empty()) return std::nullopt;
  if (numbers.size() < kLeast) return std::to_string(numbers.size()) + " numbers where none or at least 4 are required";
  Scale scale;
  std::copy_n(numbers.begin(), kLeast, scale.range.begin());
  const double kind = numbers.size() > kLeast ? numbers[kLeast] : 0;
  if (kind != 0 && kind != 1 && kind != 2) {
    return "the type " + json::number_text(kind) + " where 0, 1 or 2 is required";
  }
  scale.kind = static_cast<Kind>(static_cast<int>(kind));
  if (numbers.size() > kLeast + 2) {
    scale.left = std::clamp(numbers[kLeast + 1], 0.0, 100.0);
    scale.bottom = std::clamp(numbers[kLeast + 2], 0.0, 100.0);
  }
  const auto [x1, x2, y1, y2] = scale.range;
  const bool factors = scale.kind == Kind::kPointFactor;
  if (factors ? x2 == 0 || y2 == 0 : x1 == x2 || y1 == y2) return "a range or factor of 0";
  scale_ = scale;
  settle();
  return std::nullopt;
}

// A plotter unit is 0.025 mm: a factor beyond these bounds comes from a damaged file, and would overflow coordinates.
void UserUnits::settle() {
  constexpr double kLeastFactor = 1e-9, kMostFactor = 1e9;
  map_.reset();
  if (!scale_) return;
  const auto [x1, x2, y1, y2] = scale_->range;
  Map map;
  if (scale_->kind == Kind::kPointFactor) {
    const Spot p1 = points_ ? (*points_)[0] : Spot{};
    map = {{x2, y2}, {p1.x - x1 * x2, p1.y - y1 * y2}};
  } else if (points_) {
    const auto& [p1, p2] = *points_;
    const double width = p2.x - p1.x, height = p2.y - p1.y;
    Spot factor{width / (x2 - x1), height / (y2 - y1)}, corner = p1;
    if (scale_->kind == Kind::kIsotropic) {
      const double least = std::min(std::abs(factor.x), std::abs(factor.y));
      factor = {std::copysign(least, factor.x), std::copysign(least, factor.y)};
      corner = {p1.x + (width - factor.x * (x2 - x1)) * scale_->left / 100,
                p1.y + (height - factor.y * (y2 - y1)) * scale_->bottom / 100};
    }
    map = {factor, {corner.x - x1 * factor.x, corner.y - y1 * factor.y}};
  } else {
    return;
  }
  for (const double one : {std::abs(map.factor.x), std::abs(map.factor.y)}) {
    if (!(one >= kLeastFactor && one <= kMostFactor)) return;
  }
  map_ = map;
}

Spot UserUnits::place(Spot user) const {
  if (!map_) return user;
  return {map_->origin.x + map_->factor.x * user.x, map_->origin.y + map_->factor.y * user.y};
}

Spot UserUnits::step(Spot user) const {
  if (!map_) return user;
  return {map_->factor.x * user.x, map_->factor.y * user.y};
}

}  // namespace selvage::protocol::trade::hpgl
