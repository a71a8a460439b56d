// motion.contain: whether pieces fit, all at once, into the room that the others leave [Li94 8.3].
#include "core/packing/contain.h"

#include "core/packing/roomiest.h"
#include "protocol/methods/packing/corner.h"
#include "protocol/methods/packing/search_params.h"

namespace selvage::protocol::methods::packing {

// Which layout is the answer.
enum class BestContainment { kFirst, kRoom };

}  // namespace selvage::protocol::methods::packing

namespace selvage::protocol::schema {

template <>
struct Choices<selvage::packing::Verdict> {
  static constexpr std::string_view kName = "Verdict";
  static constexpr std::string_view kMeaning =
      "The outcome of a search for room: found, impossible (proved), or undecided, because it ended early or the fit "
      "is too tight to decide after rounding.";
  static constexpr std::string_view kWords[] = {"found", "impossible", "undecided"};
};

template <>
struct Choices<methods::packing::BestContainment> {
  static constexpr std::string_view kName = "BestContainment";
  static constexpr std::string_view kMeaning =
      "Which layout motion.contain returns: the first that it finds, or the one in which the pieces have the most "
      "room.";
  static constexpr std::string_view kWords[] = {"first", "room"};
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::packing {
namespace {

constexpr std::size_t kMostCorners = 1'000;

struct ContainParams {
  calls::CommonParams call;
  std::optional<std::vector<calls::Id>> pieces;
  std::optional<std::vector<Corner>> room;
  BestContainment best{};
  SearchEffort effort;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.optional("pieces", self.pieces, "The ids of the pieces, placed or unplaced; all unplaced pieces when absent.",
               {.entries = {{1, marker::kMaxPieces}}, .entries_are = "pieces"});
    v.optional("room", self.room,
               "Where the pieces must lie: two opposite corners of a rectangle, or 3 to 1,000 corners of a polygon; "
               "when absent, the strip up to the end of the marker as it is.",
               {.entries = {{2, kMostCorners}}, .entries_are = "corners"});
    v.optional("best", self.best, "Which layout is returned: the first one when absent.");
    v.part(self.effort);
  }
};

struct ContainResult {
  selvage::packing::Verdict verdict{};
  std::optional<double> clearance, clearance_bound;
  std::uint64_t nodes{};
  calls::RoundsResult rounds;

  static void describe(auto& v, auto& self) {
    v.required("verdict", self.verdict, "Whether the pieces fit. The marker changes only if a layout was found.");
    v.optional("clearance", self.clearance,
               "With best room, when they fit: the distance that the pieces keep beyond their spacing from each other, "
               "from all others and from the border of the room.");
    v.optional("clearanceBound", self.clearance_bound,
               "With best room: a proved upper bound on the clearance in any layout; absent when there is none.");
    v.required("nodes", self.nodes, "Number of nodes searched.");
    v.part(self.rounds);
  }
};

Result<selvage::packing::Container> container_of(const std::vector<Corner>& room, Resolution resolution) {
  Polygon corners;
  for (const Corner& corner : room) {
    const auto at = calls::place_on_lattice(corner.at, resolution, "/room/" + std::to_string(corners.size()));
    if (!at) return at.error();
    corners.push_back(*at);
  }
  if (corners.size() == 2) {
    const Box box = box_of(corners);
    if (box.width() > 0 && box.height() > 0) return selvage::packing::Container{box};
    return Error{ErrorCode::kOutOfRange, "has no area; two corners of a rectangle that differ in x and y are allowed",
                 "/room"};
  }
  const auto clean = geometry::clean_polygon(corners);
  if (clean) return selvage::packing::Container{clean->polygon};
  return Error{ErrorCode::kOutOfRange, "is not a simple polygon: " + clean.error().message, "/room"};
}

// What is found, with the clearances where they are asked for.
selvage::packing::RoomyContainment contained(const ContainParams& params, const Marker& start,
                                             const std::vector<PieceId>& pieces,
                                             const selvage::packing::Container& container, const scene::Run& run) {
  selvage::packing::ContainSettings settings;
  settings.limits = limits_of(params.effort, params.call);
  settings.turns = params.effort.turns;
  if (params.best == BestContainment::kRoom) {
    return selvage::packing::contain_with_most_room(start, pieces, container, settings, run);
  }
  selvage::packing::RoomyContainment done;
  static_cast<selvage::packing::Containment&>(done) =
      selvage::packing::contain(start, pieces, container, settings, run);
  return done;
}

Result<calls::Motion<ContainResult>> run_contain(const ContainParams& params, const Marker& start,
                                                 const calls::MethodContext& context) {
  const auto pieces = chosen_pieces(start, params.pieces);
  if (!pieces) return pieces.error();
  if (const auto refusal = too_many(pieces->size(), "pieces", "/pieces")) return *refusal;
  if (params.call.commit) {
    if (const auto defect = selvage::packing::defect_of_staying(start, *pieces)) return *defect;
  }
  selvage::packing::Container container{selvage::packing::room_until(start.strip, length_of(start))};
  if (params.room) {
    auto given = container_of(*params.room, start.resolution);
    if (!given) return given.error();
    container = *std::move(given);
  }
  auto done = contained(params, start, *pieces, container, context.run);
  ContainResult result{.verdict = done.verdict,
                       .clearance = {},
                       .clearance_bound = {},
                       .nodes = done.work.nodes,
                       .rounds = {done.rounds, stop_cause(done.reason, context)}};
  const bool roomy = params.best == BestContainment::kRoom && done.verdict == selvage::packing::Verdict::kFound;
  if (roomy) result.clearance = to_decimal(done.clearance, start.resolution);
  if (done.clearance_bound) result.clearance_bound = to_decimal(*done.clearance_bound, start.resolution);
  return calls::Motion<ContainResult>{{std::move(done.marker), done.repair}, result};
}

}  // namespace

calls::Method contain_method() {
  return calls::motion_method("motion.contain", calls::MethodKind::kMotion,
                              "Places pieces, all at once, in the room that the others leave, or proves that they do "
                              "not fit.",
                              run_contain);
}

}  // namespace selvage::protocol::methods::packing
