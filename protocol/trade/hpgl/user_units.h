// The user units of a plot: IP places the points P1 and P2 in plotter units, and SC gives them user coordinates.
// Source: Hewlett-Packard, PCL 5 Printer Language Technical Reference Manual, chapter 19, "SC (Scale)".
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "protocol/document/annotations.h"

namespace selvage::protocol::trade::hpgl {

class UserUnits {
 public:
  // The parameters of IP and SC.  IP and SC without parameters forget the points and the scale.
  void set_points(const std::vector<double>& numbers);
  // Returns what is wrong with them; the scale is then forgotten.
  [[nodiscard]] std::optional<std::string> set_scale(const std::vector<double>& numbers);

  // Whether there is a scale that cannot be followed, because the points are those of an unknown sheet of paper.
  [[nodiscard]] bool unknown() const { return scale_ && !map_; }

  // From user units to plotter units: a place, and a step.
  [[nodiscard]] document::Spot place(document::Spot user) const;
  [[nodiscard]] document::Spot step(document::Spot user) const;

 private:
  enum class Kind { kAnisotropic, kIsotropic, kPointFactor };
  struct Scale {
    Kind kind{};
    std::array<double, 4> range{};  // x and y of P1 and P2; or of P1, each with the plotter units of a user unit
    double left{50}, bottom{50};    // per cent of what an isotropic scale leaves free
  };
  struct Map {
    document::Spot factor{1, 1}, origin;
  };
  void settle();

  std::optional<std::array<document::Spot, 2>> points_;
  std::optional<Scale> scale_;
  std::optional<Map> map_;
};

}  // namespace selvage::protocol::trade::hpgl
