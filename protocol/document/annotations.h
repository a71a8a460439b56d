// What is drawn on a pattern piece besides its outline: notches, drill holes, lines and texts.  The engine does not
// read them; they travel with the shape, as "annotations" among its attributes, through every motion and file format.
//
// Units: the marker's unit, in the shape's own coordinates; angles in degrees, counter-clockwise.
//   "annotations": {"notches": [{"kind": "v", "at": [x, y], "depth": 4, "width": 2, "angle": 90}],
//                   "drills": [[x, y], ...],
//                   "lines": [{"kind": "sew", "closed": false, "points": [[x, y], ...]}],
//                   "texts": [{"text": "CF", "at": [x, y], "height": 8, "angle": 0}]}
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "protocol/json/json_text.h"

namespace selvage::protocol::document {

// A point of a pattern piece, in floating point, because nothing is proved from it.
struct Spot {
  double x{}, y{};
  friend bool operator==(const Spot&, const Spot&) = default;
};

enum class NotchKind { kV, kSlit, kT, kCastle, kCheck, kU };
inline constexpr std::array<std::string_view, 6> kNotchWords{"v", "slit", "t", "castle", "check", "u"};

// On the outline.
struct Notch {
  NotchKind kind{};
  Spot at;
  double depth{}, width{};      // 0: the file does not say
  std::optional<double> angle;  // of the direction into the piece; if absent, perpendicular to the outline
  friend bool operator==(const Notch&, const Notch&) = default;
};

enum class LineKind { kGrain, kInternal, kCutOut, kSew, kMirror, kStripe, kPlaid, kInstruction };
inline constexpr std::array<std::string_view, 8> kLineWords{"grain",  "internal", "cut_out", "sew",
                                                            "mirror", "stripe",   "plaid",   "instruction"};

struct DrawnLine {
  LineKind kind{};
  bool closed{};
  std::vector<Spot> points;  // at least two
  friend bool operator==(const DrawnLine&, const DrawnLine&) = default;
};

struct DrawnText {
  std::string text;
  Spot at;  // the left end of its base line
  double height{}, angle{};
  friend bool operator==(const DrawnText&, const DrawnText&) = default;
};

struct Annotations {
  std::vector<Notch> notches;
  std::vector<Spot> drills;
  std::vector<DrawnLine> lines;
  std::vector<DrawnText> texts;
  [[nodiscard]] bool empty() const { return notches.empty() && drills.empty() && lines.empty() && texts.empty(); }
  friend bool operator==(const Annotations&, const Annotations&) = default;
};

// Reads the annotations among a shape's attributes.  Attributes may contain anything; whatever does not have the form
// above is ignored.
[[nodiscard]] Annotations annotations_of(const Json& attributes);
// REQUIRES: every number is finite.
[[nodiscard]] Json annotations_json(const Annotations& annotations);

}  // namespace selvage::protocol::document
