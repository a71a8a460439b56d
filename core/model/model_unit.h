// The unit of a program's columns: a thousandth of the strip's width, so that every program is well scaled, whatever
// the lattice's resolution.
#pragma once

#include "core/marker/marker.h"

namespace selvage::model {

class ModelUnit {
 public:
  static constexpr double kAcross = 1000;  // units in a strip's width

  explicit ModelUnit(const Strip& strip) : lattice_units_{static_cast<double>(strip.width) / kAcross} {}
  // A unit of any size, for tests.
  [[nodiscard]] static ModelUnit of(double lattice_units) { return ModelUnit{lattice_units}; }

  [[nodiscard]] double lattice_units() const { return lattice_units_; }
  [[nodiscard]] double to_columns(double lattice_units) const { return lattice_units / lattice_units_; }
  [[nodiscard]] double to_lattice(double column_units) const { return column_units * lattice_units_; }
  // A fraction of the strip's width, in column units.
  [[nodiscard]] static constexpr double of_width(double fraction) { return fraction * kAcross; }

 private:
  explicit ModelUnit(double lattice_units) : lattice_units_{lattice_units} {}
  double lattice_units_;
};

}  // namespace selvage::model
