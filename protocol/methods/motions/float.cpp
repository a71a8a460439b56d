// motion.float: free space is distributed among the gaps between pieces [Li94 7].
#include <algorithm>

#include "core/motion/floating/float_apart.h"
#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions {
namespace {

constexpr schema::Limits kDistances{.range = {{1e-9, 1e9}}};  // in the marker's unit; the lattice may allow less
constexpr double kStandardGap = 0.01;                         // of the strip's width

struct FloatParams {
  calls::CommonParams call;
  std::optional<double> distance;
  motion::floating::FloatMode mode{};
  bool edges{};
  std::optional<int> rounds;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional("distance", self.distance,
               "Wider gaps count as this wide; with given_distance, the target gap. 1e-9 to 1e9; a hundredth of the "
               "strip's width when absent.",
               kDistances);
    v.optional("mode", self.mode, "The objective; largest_minimum when absent.");
    v.optional("edges", self.edges, "Whether gaps to the strip's edges count too.");
    v.optional("rounds", self.rounds, calls::Effort::kRoundsMeaning, calls::kRoundLimits);
  }
};

// Which gap: its piece, and the piece or the edge on the other side.
struct Gap {
  static constexpr std::string_view kName = "Gap", kMeaning = "A gap between two pieces, or a piece and an edge.";
  std::string piece;
  std::optional<std::string> other;
  std::optional<StripEdge> edge;

  static void describe(auto& v, auto& self) {
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.optional("other", self.other, "The id of the adjacent piece.");
    v.optional("edge", self.edge, "The adjacent edge, if there is no other piece.");
  }
};
struct GapWidths {
  static constexpr std::string_view kName = "GapWidths", kMeaning = "A gap and its width.";
  Gap gap;
  double before{}, after{};

  static void describe(auto& v, auto& self) {
    v.part(self.gap);
    v.required("before", self.before, "Its width before the motion.");
    v.required("after", self.after, "Its width after the motion.");
  }
};
struct CriticalSet {
  static constexpr std::string_view kName = "CriticalSet", kMeaning = "Gaps that determine a minimum.";
  double distance{};
  std::vector<Gap> gaps;

  static void describe(auto& v, auto& self) {
    v.required("distance", self.distance, "The minimum.");
    v.required("gaps", self.gaps, "The gaps that determine it.");
  }
};

struct FloatResult {
  double least_before{}, least_after{};
  bool reached{};
  std::vector<GapWidths> gaps;
  std::vector<CriticalSet> critical;
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("leastBefore", self.least_before, "The narrowest gap before the motion, at most the distance.");
    v.required("leastAfter", self.least_after,
               "The narrowest gap after the motion, proved; 0 when stopped before it was found.");
    v.required("reached", self.reached, "Whether the narrowest gap has the distance.");
    v.required("gaps", self.gaps, "The gaps narrower than the distance before or after; only some when stopped.");
    v.required("critical", self.critical, "Sets of gaps that determine a minimum.");
    v.part(self.rounds);
  }
};

Gap gap_of(const Marker& marker, const motion::floating::Gap& gap) {
  Gap named{.piece = marker.pieces[gap.piece.value].id, .other = {}, .edge = {}};
  if (const PieceId* other = other_piece(gap)) {
    named.other = marker.pieces[other->value].id;
  } else {
    named.edge = std::get<StripEdge>(gap.opposite);
  }
  return named;
}

std::vector<GapWidths> gaps_of(const Marker& marker, const std::vector<motion::floating::GapWidths>& gaps) {
  std::vector<GapWidths> list;
  for (const motion::floating::GapWidths& widths : gaps) {
    list.push_back({gap_of(marker, widths.gap), formats::in_unit(widths.before, marker.resolution),
                    formats::in_unit(widths.after, marker.resolution)});
  }
  return list;
}

std::vector<CriticalSet> critical_of(const Marker& marker, const std::vector<motion::floating::CriticalSet>& sets) {
  std::vector<CriticalSet> list;
  for (const motion::floating::CriticalSet& set : sets) {
    CriticalSet& named = list.emplace_back();
    named.distance = formats::in_unit(set.distance, marker.resolution);
    for (const motion::floating::Gap& gap : set.gaps) named.gaps.push_back(gap_of(marker, gap));
  }
  return list;
}

Result<calls::Motion<FloatResult>> run_float(const FloatParams& params, const Marker& start,
                                             const calls::MethodContext& context) {
  const double wanted = params.distance.value_or(kStandardGap * to_decimal(start.strip.width, start.resolution));
  if (!fits_lattice(wanted, start.resolution)) {
    return Error{ErrorCode::kOutOfRange,
                 json::number_text(wanted) + " is beyond the marker's lattice; up to " +
                     json::number_text(to_decimal(kLatticeLimit - 1, start.resolution)) + " is allowed",
                 "/distance"};
  }
  const Coord distance = std::max(to_lattice(wanted, start.resolution), Coord{1});
  motion::floating::FloatSettings settings = float_settings(params.mode, distance);
  settings.edges = params.edges;
  settings.rounds = params.rounds.value_or(settings.rounds);
  auto done = float_apart(start, settings, context.run);
  if (!done) return done.error();
  FloatResult result{.least_before = to_decimal(done->least_before, start.resolution),
                     .least_after = to_decimal(done->least_after, start.resolution),
                     .reached = done->reached,
                     .gaps = gaps_of(start, done->gaps),
                     .critical = critical_of(start, done->critical),
                     .rounds = {done->rounds, stop_cause(done->reason, context)}};
  return calls::Motion<FloatResult>{{std::move(done->marker), done->repair}, std::move(result)};
}

}  // namespace

calls::Method float_method() {
  return calls::motion_method("motion.float", calls::MethodKind::kMotion,
                              "Distributes free space among the gaps between pieces.", run_float);
}

}  // namespace selvage::protocol::methods::motions
