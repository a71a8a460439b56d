#include "protocol/methods/motions/float.h"

#include <algorithm>
#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr std::string_view kEdgeNames[] = {"left", "right", "bottom", "top"};  // by StripEdge

// {"piece", "other"} or {"piece", "edge"}
Json gap_json(const Marker& marker, const motion::floating::Gap& gap) {
  Json named{{"piece", marker.pieces[gap.piece.value].id}};
  if (const PieceId* other = other_piece(gap)) {
    named["other"] = marker.pieces[other->value].id;
  } else {
    named["edge"] = kEdgeNames[static_cast<std::size_t>(std::get<motion::floating::StripEdge>(gap.opposite))];
  }
  return named;
}

Json gaps_json(const Marker& marker, const std::vector<motion::floating::GapWidths>& gaps) {
  Json list = Json::array();
  for (const motion::floating::GapWidths& widths : gaps) {
    Json gap = gap_json(marker, widths.gap);
    gap["before"] = formats::in_unit(widths.before, marker.resolution);
    gap["after"] = formats::in_unit(widths.after, marker.resolution);
    list.push_back(std::move(gap));
  }
  return list;
}

Json critical_json(const Marker& marker, const std::vector<motion::floating::CriticalSet>& sets) {
  Json list = Json::array();
  for (const motion::floating::CriticalSet& set : sets) {
    Json gaps = Json::array();
    for (const motion::floating::Gap& gap : set.gaps) gaps.push_back(gap_json(marker, gap));
    list.push_back({{"distance", formats::in_unit(set.distance, marker.resolution)}, {"gaps", std::move(gaps)}});
  }
  return list;
}

Result<calls::Motion> run(const MotionFloat& wanted, const Marker& start, const calls::MethodContext& context) {
  if (!fits_lattice(wanted.distance, start.resolution)) {
    return Error{ErrorCode::kOutOfRange, json::number_text(wanted.distance) + " is beyond the marker's lattice",
                 "/distance"};
  }
  const Coord distance = std::max(to_lattice(wanted.distance, start.resolution), Coord{1});
  motion::floating::FloatSettings settings = float_settings(wanted.mode, distance);
  settings.edges = wanted.edges;
  settings.rounds = wanted.rounds.value_or(settings.rounds);
  auto done = float_apart(start, settings, context.run);
  if (!done) return done.error();
  Json figures{{"leastBefore", to_decimal(done->least_before, start.resolution)},
               {"leastAfter", to_decimal(done->least_after, start.resolution)},
               {"reached", done->reached},
               {"gaps", gaps_json(start, done->gaps)},
               {"critical", critical_json(start, done->critical)}};
  figures.update(calls::rounds_json(done->rounds, done->reason));
  return calls::Motion{std::move(done->marker), std::move(figures), done->repair};
}

constexpr std::array kParams = together(
    std::array{
        calls::Word{"distance", "number", calls::kRequired,
                    "Wider gaps count as this wide; in given_distance, the one wanted."},
        calls::Word{"mode", "FloatMode", calls::kOptional, "What is made large; largest_minimum when absent."},
        calls::Word{"edges", "boolean", calls::kOptional, "Gaps to the strip's edges count, too."},
    },
    calls::kRoundsParams);
constexpr std::array kResults = together(
    std::array{
        calls::Word{"leastBefore", "number", calls::kRequired, "The narrowest gap, at most the distance."},
        calls::Word{"leastAfter", "number", calls::kRequired, "Likewise afterwards; proved."},
        calls::Word{"reached", "boolean", calls::kRequired, "The narrowest gap has the distance."},
        calls::Word{"gaps", "GapWidths[]", calls::kRequired, "Those narrower than the distance before or after."},
        calls::Word{"critical", "CriticalSet[]", calls::kRequired, "Sets of gaps that hold a minimum."},
    },
    calls::kRoundsResults);

constexpr std::array kMethods{
    calls::MarkerMethod{"motion.float",
                        calls::MethodKind::kMove,
                        &calls::read_motion<decode_motion_float, run>,
                        {"Free space shared out among the gaps between pieces.", kParams, kResults}}};

}  // namespace

Result<MotionFloat> decode_motion_float(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionFloat wanted;
  wanted.call = calls::read_call(fields, mistake);
  wanted.distance = fields.number("distance", kFloatDistances);
  wanted.mode = static_cast<motion::floating::FloatMode>(
      fields.word_or("mode", static_cast<std::size_t>(wanted.mode), kFloatModeNames));
  wanted.edges = fields.flag_or("edges", wanted.edges);
  wanted.rounds = calls::read_rounds(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

std::span<const calls::MarkerMethod> floating_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
