#include "protocol/formats/decimal_rules.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::formats {
namespace {

using NamedLength = std::pair<std::optional<double>, std::string_view>;

std::optional<std::string_view> first_beyond(std::initializer_list<NamedLength> lengths, Resolution resolution) {
  const auto* const beyond = std::find_if(lengths.begin(), lengths.end(), [&](const NamedLength& length) {
    return !geometry::fits_lattice(length.first.value_or(0), resolution);
  });
  return beyond == lengths.end() ? std::nullopt : std::optional{beyond->second};
}

marker::Part part_on_lattice(const DecimalPart& written, Resolution resolution) {
  marker::Part part{{}, written.quality};
  for (const Decimal& corner : written.outline)
    part.outline.push_back({to_lattice(corner.x, resolution), to_lattice(corner.y, resolution)});
  return part;
}

DecimalPart decimal_part(const marker::Part& part, Resolution resolution) {
  DecimalPart written{{}, part.quality};
  for (const Vec corner : part.outline)
    written.outline.push_back({to_decimal(corner.x, resolution), to_decimal(corner.y, resolution)});
  return written;
}

}  // namespace

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
  rules.quality = written.quality;
  if (written.part) rules.part = part_on_lattice(*written.part, resolution);
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
                       .zone = {},
                       .quality = rules.quality,
                       .part = {}};
  if (rules.on_fold) written.fold = true;
  if (rules.match)
    written.match = Decimal{to_decimal(rules.match->x, resolution), to_decimal(rules.match->y, resolution)};
  if (!rules.match_set.empty()) written.match_set = rules.match_set;
  if (!rules.shade.empty()) written.shade = rules.shade;
  if (rules.zone) written.zone = true;
  if (rules.part) written.part = decimal_part(*rules.part, resolution);
  return written;
}

std::optional<std::string_view> beyond_lattice(const DecimalRules& written, Resolution resolution) {
  const Decimal match = written.match.value_or(Decimal{});
  const auto beyond = [resolution](const Decimal& corner) {
    return !geometry::fits_lattice(corner.x, resolution) || !geometry::fits_lattice(corner.y, resolution);
  };
  if (written.part && std::any_of(written.part->outline.begin(), written.part->outline.end(), beyond))
    return "/part/outline";
  return first_beyond({{written.below, "/below"},
                       {written.above, "/above"},
                       {written.from, "/from"},
                       {written.to, "/to"},
                       {match.x, "/match/0"},
                       {match.y, "/match/1"}},
                      resolution);
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

std::optional<std::string_view> beyond_lattice(const DecimalRepeat& written, Resolution resolution) {
  const Decimal phase = written.phase.value_or(Decimal{});
  return first_beyond(
      {{written.along, "/along"}, {written.across, "/across"}, {phase.x, "/phase/0"}, {phase.y, "/phase/1"}},
      resolution);
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

formats::Decimal Wire<formats::Decimal>::read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
  return formats::read_point(value, at, mistake);
}

}  // namespace selvage::protocol::schema
