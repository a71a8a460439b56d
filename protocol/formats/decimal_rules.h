// Cloth's rules (core/marker/rules.h) in decimals, as files and messages contain them: the rules of a piece, and the
// pattern of the cloth.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/marker/rules.h"
#include "protocol/json/fields.h"
#include "protocol/schema/choices.h"
#include "protocol/schema/visitors.h"

namespace selvage::protocol::formats {

struct Decimal {
  double x{}, y{};
  friend bool operator==(const Decimal&, const Decimal&) = default;
};

}  // namespace selvage::protocol::formats

namespace selvage::protocol::schema {

template <>
struct Wire<formats::Decimal> {
  static Type type();
  static Json write(const formats::Decimal& value) { return Json::array({value.x, value.y}); }
  static void read(const FieldAt& at, formats::Decimal& value);
  static formats::Decimal read_entry(const Json& value, const std::string& at, json::Mistake& mistake);
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::schema {

template <>
struct Choices<marker::Nap> {
  static constexpr std::string_view kName = "NapDirection";
  static constexpr std::string_view kMeaning =
      "How a piece lies on cloth with a nap: the x axis of its shape points to larger x (up) or to smaller x (down).";
  static constexpr std::string_view kWords[] = {"up", "down"};
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::formats {

struct DecimalPart {
  static constexpr std::string_view kName = "PiecePart",
                                    kMeaning = "A part of a piece that needs cloth of better quality than the rest.";
  std::vector<Decimal> outline;
  marker::Quality quality{};

  static void describe(auto& v, auto& self) {
    v.required("outline", self.outline,
               "The corners of the part, in the coordinates of the shape and inside its outline.",
               {.entries = {{3, geometry::kMaxVertices}}, .entries_are = "corners"});
    v.optional("quality", self.quality,
               "The worst quality class that the part accepts, less than that of the piece; 0 when absent.",
               {.range = {{0, marker::kWorstQuality - 1}}});
  }
  friend bool operator==(const DecimalPart&, const DecimalPart&) = default;
};

struct DecimalRules {
  static constexpr std::string_view kName = "PieceRules", kMeaning = "Where on the strip a piece may lie.";
  static constexpr schema::Limits kRule{.range = {{0, 1e9}}};  // lengths
  std::optional<double> below, above, from, to;
  std::optional<bool> fold;
  std::optional<Decimal> match;
  std::optional<std::string> match_set;
  std::optional<std::string> shade;
  std::optional<marker::Nap> nap;
  std::optional<bool> zone;
  std::optional<marker::Quality> quality;
  std::optional<DecimalPart> part;

  static void describe(auto& v, auto& self) {
    v.optional("below", self.below, "Its distance from the strip's lower edge, in place of the strip's own.", kRule);
    v.optional("above", self.above, "Its distance from the strip's upper edge, in place of the strip's own.", kRule);
    v.optional("from", self.from, "It lies at this x or beyond.", kRule);
    v.optional("to", self.to, "It ends at this x or before.", kRule);
    v.optional("fold", self.fold,
               "Whether its lowest side lies on the strip's lower edge, where the cloth is folded, or its highest side "
               "on the upper edge of a tube.");
    v.optional("match", self.match, "A point of its shape, which is matched to the cloth's pattern.");
    v.optional(
        "matchSet", self.match_set,
        "The name of its match set: the match points of its pieces lie whole repeats of the pattern apart, wherever "
        "on the cloth; absent: the match point lies where a repeat begins.");
    v.optional("shade", self.shade,
               "The name of its shade: the pieces of a shade lie near each other along the strip.");
    v.optional("nap", self.nap, "How it lies on cloth with a nap; absent: in any orientation that its shape allows.");
    v.optional("zone", self.zone,
               "Whether it is not a piece but a part of the cloth that no piece may cover, such as a flaw.");
    v.optional(
        "quality", self.quality,
        "The worst quality class of cloth that it accepts; absent: 0, the class of all cloth outside of zones.  Of a "
        "zone: the class of its cloth, 1 or more; absent: no piece may cover the zone.",
        {.range = {{0, marker::kWorstQuality}}});
    v.optional("part", self.part, "A part of it that needs better cloth than the rest, such as the visible one.");
  }
  friend bool operator==(const DecimalRules&, const DecimalRules&) = default;
};
// The rules on the lattice: distances are rounded so that the rule as written is kept.
[[nodiscard]] marker::Rules rules_on_lattice(const DecimalRules& written, Resolution resolution);
[[nodiscard]] DecimalRules decimal_rules(const marker::Rules& rules, Resolution resolution);
// The first field whose length is too large for the lattice, such as "/to", if there is one.
[[nodiscard]] std::optional<std::string_view> beyond_lattice(const DecimalRules& written, Resolution resolution);

struct DecimalRepeat {
  static constexpr std::string_view kName = "ClothRepeat",
                                    kMeaning = "The pattern of the cloth: stripes repeat on one axis, a plaid on both.";
  std::optional<double> along, across;
  std::optional<Decimal> phase;

  static void describe(auto& v, auto& self) {
    v.optional("along", self.along, "The length of a repeat in x; absent or 0: the pattern does not change along x.",
               DecimalRules::kRule);
    v.optional("across", self.across, "The length of a repeat in y; absent or 0: the pattern does not change along y.",
               DecimalRules::kRule);
    v.optional("phase", self.phase, "A point at which a repeat begins; [0, 0] when absent.");
  }
};
// The repeat on the lattice.  Repeats and their phase have to be whole numbers of lattice units, because rounding
// errors would add up along the cloth.  A resolution that is chosen for the marker satisfies this.
[[nodiscard]] marker::Repeat repeat_on_lattice(const DecimalRepeat& written, Resolution resolution);
[[nodiscard]] DecimalRepeat decimal_repeat(const marker::Repeat& repeat, Resolution resolution);
[[nodiscard]] std::optional<std::string_view> beyond_lattice(const DecimalRepeat& written, Resolution resolution);

}  // namespace selvage::protocol::formats
