#include "protocol/formats/decimal_rules.h"

#include <algorithm>
#include <array>

#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::formats {

marker::Rules rules_on_lattice(const DecimalRules& written, Resolution resolution) {
  marker::Rules rules;
  if (written.below) rules.below = spacing_on_lattice(*written.below, resolution);
  if (written.above) rules.above = spacing_on_lattice(*written.above, resolution);
  if (written.from) rules.from = spacing_on_lattice(*written.from, resolution);
  if (written.to) rules.to = overlap_on_lattice(*written.to, resolution);
  rules.on_fold = written.fold.value_or(false);
  if (written.match)
    rules.match = Vec{to_lattice(written.match->x, resolution), to_lattice(written.match->y, resolution)};
  rules.match_set = written.match_set.value_or("");
  rules.shade = written.shade.value_or("");
  rules.nap = written.nap;
  rules.zone = written.zone.value_or(false);
  return rules;
}

DecimalRules decimal_rules(const marker::Rules& rules, Resolution resolution) {
  const auto decimal = [resolution](std::optional<Coord> length) {
    return length ? std::optional{to_decimal(*length, resolution)} : std::nullopt;
  };
  DecimalRules written{.below = decimal(rules.below),
                       .above = decimal(rules.above),
                       .from = decimal(rules.from),
                       .to = decimal(rules.to),
                       .fold = {},
                       .match = {},
                       .match_set = {},
                       .shade = {},
                       .nap = rules.nap,
                       .zone = {}};
  if (rules.on_fold) written.fold = true;
  if (rules.match)
    written.match = Decimal{to_decimal(rules.match->x, resolution), to_decimal(rules.match->y, resolution)};
  if (!rules.match_set.empty()) written.match_set = rules.match_set;
  if (!rules.shade.empty()) written.shade = rules.shade;
  if (rules.zone) written.zone = true;
  return written;
}

bool fits_lattice(const DecimalRules& written, Resolution resolution) {
  const Decimal match = written.match.value_or(Decimal{});
  const std::array<std::optional<double>, 6> lengths{written.below, written.above, written.from,
                                                     written.to,    match.x,       match.y};
  return std::all_of(lengths.begin(), lengths.end(), [&](const std::optional<double>& length) {
    return geometry::fits_lattice(length.value_or(0), resolution);
  });
}

marker::Repeat repeat_on_lattice(const DecimalRepeat& written, Resolution resolution) {
  const Decimal phase = written.phase.value_or(Decimal{});
  return {.along = to_lattice(written.along.value_or(0), resolution),
          .across = to_lattice(written.across.value_or(0), resolution),
          .phase = {to_lattice(phase.x, resolution), to_lattice(phase.y, resolution)}};
}

DecimalRepeat decimal_repeat(const marker::Repeat& repeat, Resolution resolution) {
  DecimalRepeat written;
  if (repeat.along > 0) written.along = to_decimal(repeat.along, resolution);
  if (repeat.across > 0) written.across = to_decimal(repeat.across, resolution);
  if (repeat.phase != Vec{}) {
    written.phase = Decimal{to_decimal(repeat.phase.x, resolution), to_decimal(repeat.phase.y, resolution)};
  }
  return written;
}

bool fits_lattice(const DecimalRepeat& written, Resolution resolution) {
  const Decimal phase = written.phase.value_or(Decimal{});
  const std::array lengths{written.along.value_or(0), written.across.value_or(0), phase.x, phase.y};
  return std::all_of(lengths.begin(), lengths.end(),
                     [&](double length) { return geometry::fits_lattice(length, resolution); });
}

}  // namespace selvage::protocol::formats

namespace selvage::protocol::schema {
namespace {

const Component& point_component() {
  static const Component kPoint{
      .name = "Point", .meaning = "[x, y] in the marker's unit.", .same_as = pair_of({Type::Kind::kNumber})};
  return kPoint;
}

}  // namespace

Type Wire<formats::Decimal>::type() {
  return {.kind = Type::Kind::kNamed, .component = &point_component};
}

void Wire<formats::Decimal>::read(const FieldAt& at, formats::Decimal& value) {
  const Json& read = at.fields.array(at.key);
  if (!at.mistake) value = formats::read_point(read, at.pointer(), at.mistake);
}

}  // namespace selvage::protocol::schema
