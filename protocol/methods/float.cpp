#include "protocol/methods/float.h"

#include <algorithm>
#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

constexpr std::string_view kEdgeNames[] = {"left", "right", "bottom", "top"};  // by StripEdge

// {"piece", "other"} or {"piece", "edge"}
Json gap_json(const Marker& marker, const Gap& gap) {
  Json named{{"piece", marker.pieces[gap.piece.value].id}};
  if (const PieceId* other = other_piece(gap)) {
    named["other"] = marker.pieces[other->value].id;
  } else {
    named["edge"] = kEdgeNames[static_cast<std::size_t>(std::get<StripEdge>(gap.opposite))];
  }
  return named;
}

Json gaps_json(const Marker& marker, const std::vector<GapWidths>& gaps) {
  Json list = Json::array();
  for (const GapWidths& widths : gaps) {
    Json gap = gap_json(marker, widths.gap);
    gap["before"] = in_unit(widths.before, marker.resolution);
    gap["after"] = in_unit(widths.after, marker.resolution);
    list.push_back(std::move(gap));
  }
  return list;
}

Json critical_json(const Marker& marker, const std::vector<CriticalSet>& sets) {
  Json list = Json::array();
  for (const CriticalSet& set : sets) {
    Json gaps = Json::array();
    for (const Gap& gap : set.gaps) gaps.push_back(gap_json(marker, gap));
    list.push_back({{"distance", in_unit(set.distance, marker.resolution)}, {"gaps", std::move(gaps)}});
  }
  return list;
}

Result<Motion> run(const MotionFloat& wanted, const Marker& start, const Means& means) {
  if (!fits_lattice(wanted.distance, start.resolution)) {
    return Error{ErrorCode::kOutOfRange, number_text(wanted.distance) + " is beyond the marker's lattice", "/distance"};
  }
  const Coord distance = std::max(to_lattice(wanted.distance, start.resolution), Coord{1});
  FloatSettings settings = float_settings(wanted.mode, distance);
  settings.edges = wanted.edges;
  settings.rounds = wanted.rounds.value_or(settings.rounds);
  auto done = float_apart(start, settings, means.sums, means.stop, means.observer);
  if (!done) return done.error();
  Json figures{{"leastBefore", to_decimal(done->least_before, start.resolution)},
               {"leastAfter", to_decimal(done->least_after, start.resolution)},
               {"reached", done->reached},
               {"gaps", gaps_json(start, done->gaps)},
               {"critical", critical_json(start, done->critical)}};
  figures.update(rounds_json(done->rounds, done->reason));
  return Motion{std::move(done->marker), std::move(figures), done->healing};
}

constexpr std::array kParams = together(
    std::array{
        Word{"distance", "number", kRequired, "Wider gaps count as this wide; in given_distance, the one wanted."},
        Word{"mode", "FloatMode", kOptional, "What is made large; largest_minimum when absent."},
        Word{"edges", "boolean", kOptional, "Gaps to the strip's edges count, too."},
    },
    kRoundsParams);
constexpr std::array kResults = together(
    std::array{
        Word{"leastBefore", "number", kRequired, "The narrowest gap, at most the distance."},
        Word{"leastAfter", "number", kRequired, "Likewise afterwards; proved."},
        Word{"reached", "boolean", kRequired, "The narrowest gap has the distance."},
        Word{"gaps", "GapWidths[]", kRequired, "Those narrower than the distance before or after."},
        Word{"critical", "CriticalSet[]", kRequired, "Sets of gaps that hold a minimum."},
    },
    kRoundsResults);

constexpr std::array kMethods{
    MarkerMethod{"motion.float",
                 MethodKind::kMove,
                 &read_motion<decode_motion_float, run>,
                 {"Free space shared out among the gaps between pieces.", kParams, kResults}}};

}  // namespace

Result<MotionFloat> decode_motion_float(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionFloat wanted;
  wanted.call = read_call(fields, mistake);
  wanted.distance = fields.number("distance", kFloatDistances);
  wanted.mode = static_cast<FloatMode>(fields.word_or("mode", static_cast<std::size_t>(wanted.mode), kFloatModeNames));
  wanted.edges = fields.flag_or("edges", wanted.edges);
  wanted.rounds = read_rounds(fields);
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

std::span<const MarkerMethod> floating_methods() {
  return kMethods;
}

}  // namespace selvage
