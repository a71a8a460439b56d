#include "protocol/methods/method_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "core/base/executor.h"
#include "protocol/calls/answer.h"
#include "protocol/calls/motion.h"
#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::methods {
namespace {

using test::json;

// Runs a method on a marker.
struct Ran {
  std::optional<calls::MethodAnswer> answer;
  std::optional<Error> error;
  rpc::RpcCode code{};
};
Ran ran(const char* name, const Json& document, Json params, const Executor& executor = serial()) {
  params["markerId"] = "m1";
  const calls::Method& method = *find_method(name);
  const auto call = method.read(params);
  if (!call) return {{}, call.error(), rpc::RpcCode::kInvalidParams};
  const MarkerFile file = test::read(document);
  SumCache sums;
  auto answer = call->run(file, calls::MethodContext{scene::Run{.sums = sums, .executor = &executor}});
  if (!answer) return {{}, answer.error(), code_of_run(method, answer.error())};
  return {*std::move(answer), {}, {}};
}

Json squares_at(const Json& left, const Json& right) {
  Json document = test::native_squares();
  document["resolution"] = 1e-6;
  document["pieces"][0]["at"] = left;
  document["pieces"][1]["at"] = right;
  return document;
}
constexpr const char* kPushLeft = R"({"forces":[{"piece":"right","force":[-2,0]}]})";

TEST(Methods, HaveUniqueNames) {
  std::set<std::string_view> names;
  for (const calls::Method& method : method_table().all()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_EQ(find_method(method.name), &method);
    const std::set<std::string_view> of_markers{"marker.nest", "marker.remake", "marker.fillGaps",
                                                "marker.compactExactly"};
    EXPECT_EQ(method.motion, method.name.starts_with("motion.") || of_markers.contains(method.name)) << method.name;
    EXPECT_TRUE(method.on_marker || !method.motion) << method.name;
  }
  EXPECT_FALSE(find_method("marker.open")->on_marker);
  EXPECT_EQ(find_method("marker.nonsense"), nullptr);
}

TEST(Methods, ListsOfPiecesAreLookedUpOnceAndAreLimited) {
  Json document = test::native_squares();
  const Json square = document["pieces"][0];
  Json forces = Json::array(), pieces = Json::array();
  for (int k = 0; k < 10'000; ++k) {
    Json piece = square;
    piece["id"] = std::to_string(k);
    document["pieces"].push_back(std::move(piece));
  }
  for (int k = 0; k < 99'999; ++k) forces.push_back({{"piece", "9999"}, {"force", {1, 0}}});
  forces.push_back({{"piece", "none"}, {"force", {1, 0}}});
  const Ran pushed = ran("motion.push", document, {{"forces", std::move(forces)}});
  ASSERT_TRUE(pushed.error);
  EXPECT_EQ(pushed.error->field, "/forces/99999/piece");
  for (int k = 0; k < 20'001; ++k) pieces.push_back("none");
  const Ran aligned = ran("motion.align", document, {{"pieces", pieces}, {"side", "left"}});
  ASSERT_TRUE(aligned.error);
  EXPECT_EQ(aligned.error->field, "/pieces");
  EXPECT_EQ(aligned.error->message, "20001 pieces; 2 to 20000 are allowed");
}

TEST(Motions, AllReturnTheCommonFieldsAndTheirOwn) {
  const std::set<std::string> common{
      "name",  "pieces", "lengthBefore", "lengthAfter", "utilisationBefore", "utilisationAfter",
      "valid", "healed", "placements"};
  const auto own = [&](const char* name, const char* params) {
    const auto result = ran(name, test::native_squares(), json(params));
    EXPECT_TRUE(result.answer) << name;
    std::set<std::string> fields;
    for (const auto& [key, value] : result.answer->fields.items()) fields.insert(key);
    for (const std::string& field : common) EXPECT_EQ(fields.erase(field), 1u) << name << " " << field;
    return fields;
  };
  EXPECT_EQ(own("motion.compact", "{}"), (std::set<std::string>{"rounds", "stop"}));
  EXPECT_EQ(own("motion.push", kPushLeft), (std::set<std::string>{"gain", "rounds", "stop"}));
  EXPECT_EQ(own("motion.gravity", R"({"force":[0,1]})"), (std::set<std::string>{"gain", "rounds", "stop"}));
  EXPECT_EQ(own("motion.bump", R"({"piece":"left","direction":[0,1]})"),
            (std::set<std::string>{"at", "gain", "touching", "moved", "stop"}));
}

TEST(Pack, ProvesTheShortestMarker) {
  const auto packed = ran("motion.pack", test::native_squares(), json("{}"));
  ASSERT_TRUE(packed.answer) << packed.error->message;
  const Json& fields = packed.answer->fields;
  EXPECT_EQ(fields["found"], true);
  EXPECT_EQ(fields["proved"], true);
  EXPECT_EQ(fields["lengthAfter"], 40);
  EXPECT_LE(fields["bound"].number(), 40);
  EXPECT_GT(fields["bound"].number(), 39.99);
  ASSERT_TRUE(packed.answer->next);
  // The cloth is too short, so the marker does not change.
  Json document = test::native_squares();
  document["strip"]["longest"] = 39;
  const auto impossible = ran("motion.pack", document, json("{}"));
  ASSERT_TRUE(impossible.answer);
  EXPECT_EQ(impossible.answer->fields["found"], false);
  EXPECT_EQ(impossible.answer->fields["proved"], true);
  EXPECT_FALSE(impossible.answer->next);
}

TEST(Contain, PlacesUnplacedPiecesInTheGivenRoom) {
  Json document = test::native_squares();
  document["unplaced"] = json(R"([{"id":"third","shape":"square"}])");
  const auto contained = ran("motion.contain", document, json(R"({"room":[[0,60],[40,100]]})"));
  ASSERT_TRUE(contained.answer) << contained.error->message;
  EXPECT_EQ(contained.answer->fields["verdict"], "found");
  EXPECT_EQ(contained.answer->fields["pieces"], 3);
  EXPECT_EQ(contained.answer->fields["placements"],
            json(R"([{"id":"third","at":[0,60],"rotation":0,"flip":false,"tilt":0}])"));
  const auto tight = ran("motion.contain", document, json(R"({"room":[[0,61],[40,100]]})"));
  ASSERT_TRUE(tight.answer);
  EXPECT_EQ(tight.answer->fields["verdict"], "impossible");
  EXPECT_FALSE(tight.answer->next);
}

TEST(Contain, ReportsTheClearanceWhenMostRoomIsRequested) {
  const auto roomy = ran("motion.contain", test::native_squares(),
                         json(R"({"pieces":["right"],"room":[[40,0],[100,60]],"best":"room"})"));
  ASSERT_TRUE(roomy.answer) << roomy.error->message;
  const Json& fields = roomy.answer->fields;
  EXPECT_NEAR(fields["clearance"].number(), 10, 0.2);
  EXPECT_GT(fields["clearanceBound"].number(), 10);
  EXPECT_LT(fields["clearanceBound"].number(), 10.2);
}

TEST(Contain, RefusesInvalidPiecesAndRooms) {
  const auto none = ran("motion.contain", test::native_squares(), json("{}"));
  ASSERT_TRUE(none.error);
  EXPECT_EQ(none.error->field, "/pieces");
  const auto stranger = ran("motion.contain", test::native_squares(), json(R"({"pieces":["left","middle"]})"));
  ASSERT_TRUE(stranger.error);
  EXPECT_EQ(stranger.error->field, "/pieces/1");
  for (const char* room : {"[[10,0],[10,100]]", "[[0,0],[10,0],[20,0]]", "[[0,0],[9,9],[9,0],[0,9]]"}) {
    const auto bad =
        ran("motion.contain", test::native_squares(), json(R"({"pieces":["left"],"room":)" + std::string{room} + "}"));
    ASSERT_TRUE(bad.error) << room;
    EXPECT_EQ(bad.error->field, "/room") << room;
  }
}

TEST(Bump, ReportsThePositionTheBlockingPiecesAndTheDistance) {
  const auto bumped = ran("motion.bump", test::native_squares(), json(R"({"piece":"right","direction":[-3,0]})"));
  ASSERT_TRUE(bumped.answer);
  const Json& fields = bumped.answer->fields;
  EXPECT_EQ(fields["at"], json("[40,10]"));
  EXPECT_EQ(fields["gain"], 10);
  EXPECT_EQ(fields["touching"], json(R"(["left"])"));
  EXPECT_EQ(fields["moved"], true);
  EXPECT_EQ(fields["lengthBefore"], 90);
  EXPECT_EQ(fields["lengthAfter"], 80);
  EXPECT_EQ(fields["valid"], true);
  ASSERT_TRUE(bumped.answer->next);
  EXPECT_EQ(length_of(*bumped.answer->next), to_lattice(80, bumped.answer->next->resolution));
}

TEST(Bump, OfAPieceThatCannotMoveChangesNothing) {
  const auto still = ran("motion.bump", test::native_squares(), json(R"({"piece":"left","direction":[-1,0]})"));
  ASSERT_TRUE(still.answer);
  EXPECT_EQ(still.answer->fields["moved"], false);
  EXPECT_EQ(still.answer->fields["gain"], 0);
  EXPECT_TRUE(still.answer->fields["placements"].empty());
  EXPECT_FALSE(still.answer->next);
}

TEST(Bump, RepairsSmallOverlapsFirstAndReportsEveryPieceThatMoved) {
  const auto bumped =
      ran("motion.bump", squares_at({0, 0}, {39.995, 10}), json(R"({"piece":"right","direction":[0,1]})"));
  ASSERT_TRUE(bumped.answer) << bumped.error->message;
  EXPECT_EQ(bumped.answer->fields["healed"]["pairs"], 1);
  EXPECT_EQ(bumped.answer->fields["at"][1], 60);
  EXPECT_EQ(bumped.answer->fields["valid"], true);
}

TEST(Push, MovesPushedPiecesAtFixedLength) {
  const auto pushed =
      ran("motion.push", test::native_squares(), json(R"({"forces":[{"piece":"left","force":[5,0]}]})"));
  ASSERT_TRUE(pushed.answer);
  EXPECT_EQ(pushed.answer->fields["gain"], 10);
  EXPECT_EQ(pushed.answer->fields["lengthAfter"], 90);
  EXPECT_EQ(pushed.answer->fields["placements"],
            json(R"([{"id":"left","at":[10,0],"rotation":0,"flip":false,"tilt":0}])"));
}

TEST(Push, AddsUpTheForcesOnOnePiece) {
  const auto pushed = ran("motion.push", test::native_squares(),
                          json(R"({"forces":[{"piece":"left","force":[1,0]},{"piece":"left","force":[-1,2]}]})"));
  ASSERT_TRUE(pushed.answer);
  EXPECT_EQ(pushed.answer->fields["placements"][0]["at"], json("[0,60]"));
}

TEST(Gravity, IsAPushOnEveryPiece) {
  const auto fallen = ran("motion.gravity", test::native_squares(), json(R"({"force":[0,3]})"));
  const auto pushed = ran("motion.push", test::native_squares(),
                          json(R"({"forces":[{"piece":"left","force":[0,1]},{"piece":"right","force":[0,1]}]})"));
  ASSERT_TRUE(fallen.answer && pushed.answer);
  EXPECT_EQ(json::to_text(fallen.answer->fields), json::to_text(pushed.answer->fields));
  EXPECT_EQ(fallen.answer->fields["gain"], 110);
}

TEST(Place, GoesToTheNearestFreePosition) {
  const auto placed =
      ran("motion.place", squares_at({0, 0}, {10, 5}), json(R"({"piece":"right","to":[35,20],"mayGrow":true})"));
  ASSERT_TRUE(placed.answer) << placed.error->message;
  EXPECT_EQ(placed.answer->fields["found"], true);
  EXPECT_EQ(placed.answer->fields["at"], json("[10,40]"));  // within the length there is only room above
  EXPECT_EQ(placed.answer->fields["grown"], false);
  const auto far = ran("motion.place", test::native_squares(), json(R"({"piece":"right","to":[1e300,0]})"));
  ASSERT_TRUE(far.error);
  EXPECT_EQ(far.error->field, "/to");
}

TEST(OpenGap, ReportsTheAreaBeforeAndAfter) {
  const auto opened = ran("motion.openGap", test::native_squares(), json(R"({"point":[45,20]})"));
  ASSERT_TRUE(opened.answer) << opened.error->message;
  EXPECT_GE(opened.answer->fields["areaAfter"].number(), opened.answer->fields["areaBefore"].number());
  EXPECT_EQ(opened.answer->fields["valid"], true);
  const auto covered = ran("motion.openGap", test::native_squares(), json(R"({"point":[20,20]})"));
  EXPECT_TRUE(covered.error);
  const auto both = ran("motion.openGap", test::native_squares(), json(R"({"point":[20,20],"region":0})"));
  ASSERT_TRUE(both.error);
  EXPECT_EQ(both.error->field, "/point");
}

TEST(Regions, AreListedWithTheirAdjacentPieces) {
  const auto listed = ran("marker.regions", test::native_squares(), json(R"({"clearance":0.1})"));
  ASSERT_TRUE(listed.answer);
  const Json& regions = listed.answer->fields["regions"];
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_NEAR(regions[0]["area"].get<double>(), 90 * 100 - 2 * 40 * 40, 60);
  EXPECT_EQ(regions[0]["around"], json(R"(["left","right"])"));
}

TEST(Tilt, ReportsTheGainOfTilting) {
  Json document = test::native_squares();
  document["pieces"][1]["tilt"] = 2;
  document["shapes"][0]["tilt_limit"] = 2;
  const auto tilted = ran("motion.tilt", document, json(R"({"limit":2.5})"));
  ASSERT_TRUE(tilted.answer) << tilted.error->message;
  const Json& fields = tilted.answer->fields;
  EXPECT_LE(fields["lengthAfter"].number(), fields["lengthCompacted"].number());
  EXPECT_LE(fields["farthestTilt"].number(), 2.5);
  EXPECT_EQ(fields["valid"], true);
}

TEST(Relax, GoesToTheMiddleOfItsRoom) {
  const auto relaxed = ran("motion.relax", test::native_squares(), json(R"({"piece":"right"})"));
  ASSERT_TRUE(relaxed.answer) << relaxed.error->message;
  EXPECT_GT(relaxed.answer->fields["freedom"].number(), 4);
  EXPECT_EQ(relaxed.answer->fields["valid"], true);
  EXPECT_EQ(ran("motion.relax", test::native_squares(), json(R"({"piece":"up"})")).error->field, "/piece");
}

TEST(Baselines, NeverLengthen) {
  for (const char* name : {"motion.oneAtATime", "motion.velocity"}) {
    const auto done = ran(name, test::native_squares(), json("{}"));
    ASSERT_TRUE(done.answer) << name;
    EXPECT_LE(done.answer->fields["lengthAfter"].number(), 90) << name;
    EXPECT_EQ(done.answer->fields["valid"], true) << name;
  }
}

TEST(Motions, RefuseDeepOverlapsAndNameThePieces) {
  const Json deep = squares_at({0, 0}, {20, 10});
  for (const auto& [name, params] : {std::pair{"motion.compact", "{}"},
                                     {"motion.push", kPushLeft},
                                     {"motion.gravity", R"({"force":[1,0]})"},
                                     {"motion.bump", R"({"piece":"right","direction":[1,0]})"}}) {
    const auto refused = ran(name, deep, json(params));
    ASSERT_TRUE(refused.error) << name;
    EXPECT_EQ(refused.code, rpc::RpcCode::kMotionRefused);
    EXPECT_EQ(refused.error->code, ErrorCode::kMarkerOverlaps);
    EXPECT_NE(refused.error->message.find("\"left\" and \"right\""), std::string::npos) << refused.error->message;
  }
}

TEST(Motions, NameAnUnknownPiece) {
  const auto bumped = ran("motion.bump", test::native_squares(), json(R"({"piece":"up","direction":[1,0]})"));
  ASSERT_TRUE(bumped.error);
  EXPECT_EQ(bumped.code, rpc::RpcCode::kInvalidParams);
  EXPECT_EQ(bumped.error->field, "/piece");
  const auto pushed = ran("motion.push", test::native_squares(),
                          json(R"({"forces":[{"piece":"left","force":[1,0]},{"piece":"up","force":[1,0]}]})"));
  ASSERT_TRUE(pushed.error);
  EXPECT_EQ(pushed.code, rpc::RpcCode::kInvalidParams);
  EXPECT_EQ(pushed.error->field, "/forces/1/piece");
}

TEST(Motions, ADryRunHasNoNextMarker) {
  const auto dry = ran("motion.compact", test::native_squares(), json(R"({"commit":false})"));
  ASSERT_TRUE(dry.answer);
  EXPECT_EQ(dry.answer->fields["lengthAfter"], 80);
  EXPECT_FALSE(dry.answer->next);
}

TEST(Motions, AnInvalidResultIsReportedAndNotKept) {
  const Marker start = test::read(test::native_squares()).marker;
  SumCache sums;
  const scene::Run run{sums};
  calls::MotionEnd end{.marker = start};
  for (Piece& piece : end.marker.pieces) piece.at = {};
  const calls::MethodAnswer wrong = answer_of(start, end, Json::object(), true, {run});
  EXPECT_EQ(wrong.fields["valid"], false);
  EXPECT_FALSE(wrong.next);
  end.keep_invalid = true;
  EXPECT_TRUE(answer_of(start, end, Json::object(), true, {run}).next);
}

TEST(Motions, ReportTheReasonForStopping) {
  SumCache sums;
  const scene::Run run{sums};
  EXPECT_EQ(calls::stop_cause(scene::StopReason::kConverged, {run}), calls::StopCause::kConverged);
  EXPECT_EQ(calls::stop_cause(scene::StopReason::kSolverFailed, {run}), calls::StopCause::kSolverFailed);
  EXPECT_EQ(calls::stop_cause(scene::StopReason::kCancelled, {run}), calls::StopCause::kCancelled);
  const calls::MethodContext late{run, nullptr, [] { return true; }};
  EXPECT_EQ(calls::stop_cause(scene::StopReason::kCancelled, late), calls::StopCause::kDeadline);
  EXPECT_EQ(calls::stop_cause(scene::StopReason::kWorkLimit, late), calls::StopCause::kWorkLimit);
}

TEST(Motions, TimesComeLastAndOnlyOnRequest) {
  Json fields{{"valid", true}};
  calls::add_times(fields, {}, {});
  EXPECT_EQ(
      json::to_text(calls::result_json("m1", 3, fields)).find(R"({"markerId":"m1","revision":3,"valid":true,"ms":{)"),
      0u);
  EXPECT_TRUE(fields.contains("cache"));
}

// Has threads to spare, and notes how many parts it was given at once.
class Counting : public Executor {
 public:
  explicit Counting(std::size_t threads) : threads_{threads} {}
  [[nodiscard]] std::size_t parallelism() const override { return threads_; }
  void for_each(std::size_t count, const Part& part) const override {
    most = std::max(most, count);
    for (std::size_t k = 0; k < count; ++k) part(k);
  }
  mutable std::size_t most{};

 private:
  std::size_t threads_;
};

TEST(Nesting, SearchesOnAllSpareThreadsWhenOnlyTimeIsLimited) {
  const auto searches = [](std::size_t threads, const char* params) {
    const Counting executor{threads};
    EXPECT_TRUE(ran("marker.nest", test::native_squares(), json(params), executor).answer) << params;
    return executor.most;
  };
  EXPECT_EQ(searches(5, R"({"seconds":0})"), 5u);
  EXPECT_EQ(searches(40, R"({"seconds":0})"), 16u);
  EXPECT_EQ(searches(5, R"({"seconds":0,"searches":2})"), 2u);
  EXPECT_EQ(searches(5, R"({"moves":10})"), 1u);
}

TEST(MarkerGet, InAFormatThatCannotExpressTheMarkerIsAnInvalidParameter) {
  Json document = test::native_squares();
  document["shapes"][0]["flip"] = true;
  document["pieces"][1].update(json(R"({"flip":true,"at":[50,60]})"));
  const auto refused = ran("marker.get", document, json(R"({"format":"sparrow"})"));
  ASSERT_TRUE(refused.error);
  EXPECT_EQ(refused.code, rpc::RpcCode::kInvalidParams);
}

}  // namespace
}  // namespace selvage::protocol::methods
