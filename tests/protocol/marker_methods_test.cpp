#include "protocol/marker_methods.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/protocol/samples.h"

namespace selvage {
namespace {

using test::json;

// A method run on a marker.
struct Ran {
  std::optional<MethodAnswer> answer;
  std::optional<Error> error;
  RpcCode code{};
};
Ran ran(const char* name, const Json& document, Json params, const Engine& engine = {}) {
  params["markerId"] = "m1";
  const MarkerMethod& method = *find_marker_method(name);
  const auto call = method.read(params);
  if (!call) return {{}, call.error(), RpcCode::kInvalidParams};
  const MarkerFile file = test::read(document);
  SumCache sums;
  auto answer = call->run(file, Means{engine, sums, {}, {}});
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

TEST(MarkerMethods, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const MarkerMethod& method : marker_methods()) {
    EXPECT_TRUE(names.insert(method.name).second) << method.name;
    EXPECT_EQ(find_marker_method(method.name), &method);
    EXPECT_EQ(method.motion, method.name.starts_with("motion.")) << method.name;
  }
  EXPECT_EQ(find_marker_method("marker.open"), nullptr);
}

TEST(Motions, AllTellTheSameFieldsBesideTheirOwn) {
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
            (std::set<std::string>{"at", "gain", "touching", "moved"}));
}

TEST(Bump, TellsWhereWhatHoldsItAndHowFar) {
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

TEST(Bump, OfAPieceThatCannotMoveMakesNoNextMarker) {
  const auto still = ran("motion.bump", test::native_squares(), json(R"({"piece":"left","direction":[-1,0]})"));
  ASSERT_TRUE(still.answer);
  EXPECT_EQ(still.answer->fields["moved"], false);
  EXPECT_EQ(still.answer->fields["gain"], 0);
  EXPECT_TRUE(still.answer->fields["placements"].empty());
  EXPECT_FALSE(still.answer->next);
}

TEST(Bump, HealsSmallOverlapsFirstAndTellsAllThatMoved) {
  const auto bumped =
      ran("motion.bump", squares_at({0, 0}, {39.995, 10}), json(R"({"piece":"right","direction":[0,1]})"));
  ASSERT_TRUE(bumped.answer) << bumped.error->message;
  EXPECT_EQ(bumped.answer->fields["healed"]["pairs"], 1);
  EXPECT_EQ(bumped.answer->fields["at"][1], 60);
  EXPECT_EQ(bumped.answer->fields["valid"], true);
}

TEST(Push, MovesWhatIsPushedAndHoldsTheLength) {
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
  EXPECT_EQ(to_text(fallen.answer->fields), to_text(pushed.answer->fields));
  EXPECT_EQ(fallen.answer->fields["gain"], 110);
}

TEST(Motions, RefuseDeepOverlapsByName) {
  const Json deep = squares_at({0, 0}, {20, 10});
  for (const auto& [name, params] : {std::pair{"motion.compact", "{}"},
                                     {"motion.push", kPushLeft},
                                     {"motion.gravity", R"({"force":[1,0]})"},
                                     {"motion.bump", R"({"piece":"right","direction":[1,0]})"}}) {
    const auto refused = ran(name, deep, json(params));
    ASSERT_TRUE(refused.error) << name;
    EXPECT_EQ(refused.code, RpcCode::kMotionRefused);
    EXPECT_EQ(refused.error->code, ErrorCode::kMarkerOverlaps);
    EXPECT_NE(refused.error->message.find("\"left\" and \"right\""), std::string::npos) << refused.error->message;
  }
}

TEST(Motions, NameThePieceThatIsNotThere) {
  const auto bumped = ran("motion.bump", test::native_squares(), json(R"({"piece":"up","direction":[1,0]})"));
  ASSERT_TRUE(bumped.error);
  EXPECT_EQ(bumped.code, RpcCode::kInvalidParams);
  EXPECT_EQ(bumped.error->field, "/piece");
  const auto pushed = ran("motion.push", test::native_squares(),
                          json(R"({"forces":[{"piece":"left","force":[1,0]},{"piece":"up","force":[1,0]}]})"));
  ASSERT_TRUE(pushed.error);
  EXPECT_EQ(pushed.code, RpcCode::kInvalidParams);
  EXPECT_EQ(pushed.error->field, "/forces/1/piece");
}

TEST(Motions, ADryRunHasNoNextMarker) {
  const auto dry = ran("motion.compact", test::native_squares(), json(R"({"commit":false})"));
  ASSERT_TRUE(dry.answer);
  EXPECT_EQ(dry.answer->fields["lengthAfter"], 80);
  EXPECT_FALSE(dry.answer->next);
}

TEST(Motions, WhatIsNotValidIsSaidAndNotKept) {
  Engine engine;
  engine.compact = [](const Marker& start, auto&&...) -> Result<Compaction> {
    Compaction done;
    done.marker = start;
    for (Piece& piece : done.marker.pieces) piece.at = {};
    return done;
  };
  const auto wrong = ran("motion.compact", test::native_squares(), json("{}"), engine);
  ASSERT_TRUE(wrong.answer);
  EXPECT_EQ(wrong.answer->fields["valid"], false);
  EXPECT_FALSE(wrong.answer->next);
}

TEST(Motions, TimesComeLastAndOnlyWhenTold) {
  Json fields{{"valid", true}};
  tell_times(fields, {}, {});
  EXPECT_EQ(to_text(result_json("m1", 3, fields)).find(R"({"markerId":"m1","revision":3,"valid":true,"ms":{)"), 0u);
  EXPECT_TRUE(fields.contains("cache"));
}

TEST(MarkerGet, OfAFormThatHasNoWordForItIsAWrongParameter) {
  Json document = test::native_squares();
  document["shapes"][0]["flip"] = true;
  document["pieces"][1].update(json(R"({"flip":true,"at":[50,60]})"));
  const auto refused = ran("marker.get", document, json(R"({"format":"sparrow"})"));
  ASSERT_TRUE(refused.error);
  EXPECT_EQ(refused.code, RpcCode::kInvalidParams);
}

}  // namespace
}  // namespace selvage
