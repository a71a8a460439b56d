// A family of tuning constants, and the effect on a motion's answer and processor time when one of them is multiplied
// by a factor.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/marker/marker.h"
#include "core/minkowski/cache.h"

namespace selvage::bench::sensitivity {

// One run.  A smaller result is better; it is relative: 1 % more is 1 % worse.
struct Outcome {
  double result{};
  bool failed{};  // there is no answer to compare
};

// The interface of a family to the table, independent of the type of the motion's settings.
struct Constant {
  std::string name, value;
  std::function<Outcome(const Marker&, double factor, SumCache&)> run;
};

struct Family {
  std::string name;    // of the motion
  std::string result;  // a description of what is compared
  // The input of the motion, made from a laid-out marker.
  std::function<Marker(const Marker&, SumCache&)> prepared;
  std::vector<Constant> constants;
};

// A field of a tuning structure.  A fraction that is close to 1 is varied by its distance from 1.
template <class Tuning>
struct Field {
  std::string name;
  std::variant<double Tuning::*, int Tuning::*, unsigned Tuning::*, std::size_t Tuning::*, Coord Tuning::*> member;
  bool from_one{false};
};

template <class Value>
Value scaled(Value value, double factor, bool from_one) {
  if constexpr (std::is_same_v<Value, double>) {
    return from_one ? 1 - (1 - value) * factor : value * factor;
  } else {
    return static_cast<Value>(std::max(1LL, std::llround(static_cast<double>(value) * factor)));
  }
}

// The constants of one tuning structure within a motion's settings: `tuning_of` finds it there, `run` runs the motion.
template <class Tuning, class Settings>
std::vector<Constant> constants_of(const Settings& settings, const std::vector<Field<Tuning>>& fields,
                                   Tuning& (*tuning_of)(Settings&),
                                   Outcome (*run)(const Marker&, const Settings&, SumCache&)) {
  std::vector<Constant> constants;
  for (const Field<Tuning>& field : fields) {
    Settings usual = settings;
    std::ostringstream value;
    std::visit([&](auto member) { value << tuning_of(usual).*member; }, field.member);
    constants.push_back({field.name, value.str(), [=](const Marker& marker, double factor, SumCache& sums) {
                           Settings changed = settings;
                           std::visit(
                               [&](auto member) {
                                 auto& constant = tuning_of(changed).*member;
                                 constant = scaled(constant, factor, field.from_one);
                               },
                               field.member);
                           return run(marker, changed, sums);
                         }});
  }
  return constants;
}

// The families that can be measured, by name: compaction, separation, tilting, floating, search, nesting,
// walks, turns.
[[nodiscard]] std::vector<Family> families();

}  // namespace selvage::bench::sensitivity
