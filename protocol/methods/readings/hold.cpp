// marker.hold: the critical path, which determines a marker's length.
#include "core/motion/compaction/critical_path.h"
#include "protocol/calls/choices.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::readings {
namespace {

struct LoadedContact {
  static constexpr std::string_view kName = "LoadedContact", kMeaning = "A contact of the critical path.";
  std::string piece;
  std::optional<std::string> other;
  std::optional<StripEdge> edge;
  double worth{};
  calls::Point at;

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.optional("other", self.other, "The id of the adjacent piece.");
    v.optional("edge", self.edge, "The adjacent edge, if there is no other piece.");
    v.required("worth", self.worth, "How much shorter the marker would become per unit of room here.");
    v.required("at", self.at, "The point where they touch.");
  }
};

struct TiltWorth {
  static constexpr std::string_view kName = "TiltWorth", kMeaning = "What tilting a piece would gain.";
  std::string piece;
  double per_degree{};

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("perDegree", self.per_degree, "How much the marker would shorten per degree of counter-clockwise tilt.");
  }
};

struct LockPrice {
  static constexpr std::string_view kName = "LockPrice", kMeaning = "What the lock of a piece costs.";
  std::string piece;
  std::optional<double> per_x, per_y;

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.optional(
        "perX", self.per_x,
        "Locked along x: how much the marker would shorten per unit by which the piece, with its group, is moved "
        "to the right; negative: to the left.");
    v.optional("perY", self.per_y, "Locked along y: likewise, upwards; negative: downwards.");
  }
};

struct RulePrice {
  static constexpr std::string_view kName = "RulePrice", kMeaning = "What one of cloth's rules costs.";
  motion::compaction::Rule rule{};
  std::optional<std::string> piece, shade;
  double worth{};

  static void describe(auto& v, auto& self) {
    v.required("rule", self.rule, "The rule.");
    v.optional("piece", self.piece,
               "The id of the piece whose rule it is; absent for the strip's selvedges and shades.");
    v.optional("shade", self.shade, "The name of the shade, when the rule is a shade.");
    v.required("worth", self.worth, "How much shorter the marker would become per unit by which the rule is relaxed.");
  }
};

struct HoldResult {
  double length{};
  std::vector<LoadedContact> contacts;
  std::vector<TiltWorth> tilts;
  double per_spacing{};
  std::optional<std::vector<LockPrice>> locks;
  std::optional<std::vector<RulePrice>> rules;

  static void describe(auto& v, auto& self) {
    v.required("length", self.length, calls::kLengthMeaning);
    v.required("contacts", self.contacts, "The contacts that carry load, from left to right.");
    v.required("tilts", self.tilts, "What tilting a piece would gain, the largest first.");
    v.required("perSpacing", self.per_spacing,
               "How much the marker would shorten per unit less spacing or more overlap allowance.");
    v.optional("locks", self.locks, "The locks that carry load; absent when there are none.");
    v.optional("rules", self.rules, "The rules that carry load, the costliest first; absent when there are none.");
  }
};

LoadedContact contact_of(const Marker& marker, const motion::compaction::LoadedContact& contact) {
  LoadedContact named{.piece = marker.pieces[contact.first.value].id,
                      .other = {},
                      .edge = {},
                      .worth = contact.worth,
                      .at = calls::point_of(contact.at.x, contact.at.y, marker.resolution)};
  if (contact.second) {
    named.other = marker.pieces[contact.second->value].id;
  } else {
    named.edge = contact.edge;
  }
  return named;
}

RulePrice price_of(const Marker& marker, const motion::compaction::RulePrice& price) {
  RulePrice named{.rule = price.rule, .piece = {}, .shade = {}, .worth = price.worth};
  if (!price.piece) return named;
  const Piece& piece = marker.pieces[price.piece->value];
  if (price.rule == motion::compaction::Rule::kShade) {
    named.shade = piece.rules.shade;
  } else {
    named.piece = piece.id;
  }
  return named;
}

Result<HoldResult> run_hold(const AnalysisParams&, const MarkerFile& file, const calls::MethodContext& context) {
  const Marker& marker = file.marker;
  const auto path = motion::compaction::critical_path(marker, context.run);
  if (!path) return path.error();
  HoldResult result{.length = to_decimal(length_of(marker), marker.resolution),
                    .contacts = {},
                    .tilts = {},
                    .per_spacing = path->per_spacing,
                    .locks = {},
                    .rules = {}};
  for (const auto& contact : path->contacts) result.contacts.push_back(contact_of(marker, contact));
  for (const motion::compaction::TiltWorth& tilt : path->tilts) {
    result.tilts.push_back({marker.pieces[tilt.piece.value].id, formats::in_unit(tilt.per_degree, marker.resolution)});
  }
  for (const motion::compaction::LockPrice& lock : path->locks) {
    if (!result.locks) result.locks.emplace();
    result.locks->push_back({marker.pieces[lock.piece.value].id, lock.per_x, lock.per_y});
  }
  for (const motion::compaction::RulePrice& price : path->rules) {
    if (!result.rules) result.rules.emplace();
    result.rules->push_back(price_of(marker, price));
  }
  return result;
}

}  // namespace

calls::Method hold_method() {
  return reading_method("marker.hold", calls::MethodKind::kAnalysis,
                        "The critical path, which determines the marker's length.", run_hold);
}

}  // namespace selvage::protocol::methods::readings
