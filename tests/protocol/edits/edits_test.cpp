// Operations on a marker, and the moves between two of its states.
#include "protocol/edits/edits.h"

#include <gtest/gtest.h>

#include "protocol/edits/changes.h"
#include "protocol/edits/moves.h"
#include "tests/protocol/formats/samples.h"

namespace selvage::protocol::edits {
namespace {

Result<MarkerFile> edited(const MarkerFile& file, std::string ops) {
  std::replace(ops.begin(), ops.end(), '\'', '"');
  const auto wanted = schema::decode<ApplyParams>({{"markerId", "m1"}, {"ops", test::json("[" + ops + "]")}});
  if (!wanted) return wanted.error();
  return apply_edits(file, wanted->edits);
}

// A marker whose pieces may have any orientation.
MarkerFile loose() {
  Json document = test::native_squares();
  document["shapes"][0]["rotations"] = "any";
  document["shapes"][0]["flip"] = true;
  document["shapes"][0]["tilt_limit"] = 5;
  document["pieces"][0]["attributes"] = {{"bundle", 7}};
  return test::read(document);
}

void expect_error(const MarkerFile& file, const std::string& ops, ErrorCode code, const std::string& field) {
  const auto after = edited(file, ops);
  ASSERT_FALSE(after) << ops;
  EXPECT_EQ(after.error().code, code) << ops << " " << after.error().message;
  EXPECT_EQ(after.error().field, field) << ops;
}

TEST(Edits, PiecesAreTakenOffTheClothAndLaidOnItAgain) {
  const auto off = edited(loose(), "{'op':'takeOff','piece':'left'}");
  ASSERT_TRUE(off) << off.error().message;
  ASSERT_EQ(off->marker.unplaced.size(), 1U);
  EXPECT_EQ(off->marker.unplaced[0].id, "left");
  EXPECT_EQ(off->marker.unplaced[0].at, Vec{});
  EXPECT_EQ(off->attributes.unplaced[0], test::json("{\"bundle\":7}"));
  EXPECT_EQ(off->marker.pieces.size(), 1U);
  const Change change = change_between(loose(), *off);
  EXPECT_EQ(change.removed, std::vector<std::string>{"left"});
  EXPECT_TRUE(change.whole);

  const auto on = edited(*off, "{'op':'place','piece':'left','at':[3,40],'rotation':90,'flip':true}");
  ASSERT_TRUE(on) << on.error().message;
  EXPECT_TRUE(on->marker.unplaced.empty());
  EXPECT_TRUE(on->attributes.unplaced.empty());
  EXPECT_EQ(on->marker.pieces[1].id, "left");
  EXPECT_EQ(on->marker.pieces[1].orientation, (Orientation{true, Angle{90}, Angle{}}));
  EXPECT_EQ(formats::point_json(on->marker.pieces[1].at, on->marker.resolution), test::json("[3,40]"));
  EXPECT_EQ(on->attributes.pieces[1], test::json("{\"bundle\":7}"));

  // Taken off and placed within one call; and removed while unplaced.
  EXPECT_TRUE(edited(loose(), "{'op':'takeOff','piece':'left'},{'op':'place','piece':'left','at':[0,0]}"));
  EXPECT_TRUE(edited(*off, "{'op':'remove','piece':'left'}")->marker.unplaced.empty());
}

TEST(Edits, OfUnplacedPiecesReportMistakes) {
  expect_error(loose(), "{'op':'place','piece':'left','at':[0,0]}", ErrorCode::kOutOfRange, "/ops/0/piece");
  expect_error(loose(), "{'op':'takeOff','piece':'none'}", ErrorCode::kOutOfRange, "/ops/0/piece");
  const auto off = edited(loose(), "{'op':'takeOff','piece':'left'}");
  ASSERT_TRUE(off);
  expect_error(*off, "{'op':'move','piece':'left','by':[1,0]}", ErrorCode::kOutOfRange, "/ops/0/piece");
  expect_error(*off, "{'op':'add','piece':{'id':'left','shape':'square','at':[0,0]}}", ErrorCode::kDuplicateId,
               "/ops/0/piece/id");
  expect_error(*off, "{'op':'place','piece':'left','at':[1e300,0]}", ErrorCode::kBeyondLattice, "/ops/0/at");
}

TEST(Edits, ErrorsOfLengthsBeyondTheLatticeNameTheLimit) {
  for (const char* op :
       {"{'op':'setSpacing','spacing':1e8}", "{'op':'setStrip','longest':1e8}",
        "{'op':'move','piece':'left','at':[1e300,0]}", "{'op':'rules','piece':'left','rules':{'to':1e9}}"}) {
    const auto after = edited(loose(), op);
    ASSERT_FALSE(after) << op;
    EXPECT_NE(after.error().message.find("; up to "), std::string::npos) << op << ": " << after.error().message;
  }
}

TEST(Edits, EachOperationHasItsEffect) {
  const auto after = edited(loose(), R"({'op':'move','piece':'left','by':[1.5,2]},
      {'op':'rotate','piece':'left','to':80},{'op':'rotate','piece':'left','by':10},
      {'op':'flip','piece':'left'},{'op':'flip','piece':'right','flip':false},
      {'op':'tilt','piece':'left','to':1},{'op':'tilt','piece':'left','by':-3},
      {'op':'lock','piece':'right'},{'op':'setStrip','width':90,'longest':300},{'op':'setSpacing','spacing':0.25},
      {'op':'group','piece':'left','group':'bundle'},{'op':'buffer','piece':'left','buffer':0.75},
      {'op':'lock','piece':'left','locked':['x','tilt']},{'op':'setStrip','margin':2},
      {'op':'setOverlap','overlap':1.5},{'op':'overlap','piece':'right','overlap':0.5})");
  ASSERT_TRUE(after) << after.error().message << after.error().field;
  const Marker& marker = after->marker;
  EXPECT_EQ(formats::point_json(marker.pieces[0].at, marker.resolution), test::json("[1.5,2]"));
  EXPECT_EQ(marker.pieces[0].orientation, (Orientation{true, Angle{90}, Angle{-2}}));
  EXPECT_FALSE(marker.pieces[1].orientation.flip);
  EXPECT_EQ(marker.pieces[1].locked, Locks{true});
  EXPECT_EQ(marker.pieces[0].locked, (Locks{true, false, true}));
  EXPECT_EQ(marker.pieces[0].group, "bundle");
  EXPECT_EQ(to_decimal(marker.pieces[0].buffer, marker.resolution), 0.75);
  EXPECT_EQ(to_decimal(marker.strip.margin, marker.resolution), 2);
  EXPECT_EQ(schema::encode(calls::state_of(marker, marker.pieces[0]))["locked"], test::json(R"(["x","tilt"])"));
  EXPECT_EQ(to_decimal(marker.strip.width, marker.resolution), 90);
  EXPECT_EQ(to_decimal(*marker.strip.longest, marker.resolution), 300);
  EXPECT_EQ(to_decimal(marker.spacing, marker.resolution), 0.25);
  EXPECT_FALSE(edited(*after, "{'op':'setStrip','longest':null}")->marker.strip.longest);
  EXPECT_EQ(to_decimal(marker.overlap, marker.resolution), 1.5);
  EXPECT_FALSE(marker.pieces[0].overlap);
  EXPECT_EQ(to_decimal(marker.pieces[1].overlap.value(), marker.resolution), 0.5);
  EXPECT_EQ(schema::encode(calls::state_of(marker, marker.pieces[1]))["overlap"], 0.5);
  EXPECT_FALSE(edited(*after, "{'op':'overlap','piece':'right'}")->marker.pieces[1].overlap);
}

TEST(Edits, SetClothsRules) {
  const auto after =
      edited(loose(), R"({'op':'setStrip','below':1.5,'above':0.25,'repeat':{'across':2}},{'op':'setShade','shade':400},
      {'op':'rules','piece':'left','rules':{'above':0,'shade':'A'}},{'op':'rules','piece':'right','rules':{'to':300}})");
  ASSERT_TRUE(after) << after.error().message << after.error().field;
  const Marker& marker = after->marker;
  EXPECT_EQ(to_decimal(marker.strip.below.value(), marker.resolution), 1.5);
  EXPECT_EQ(to_decimal(marker.strip.repeat.across, marker.resolution), 2);
  EXPECT_EQ(to_decimal(marker.shade.value(), marker.resolution), 400);
  EXPECT_EQ(marker.pieces[0].rules, (marker::Rules{.above = 0, .shade = "A"}));
  EXPECT_EQ(schema::encode(calls::state_of(marker, marker.pieces[1]))["rules"], test::json(R"({"to":300})"));
  EXPECT_FALSE(schema::encode(calls::state_of(loose().marker, loose().marker.pieces[1])).contains("rules"));
  const auto without = edited(*after, R"({'op':'rules','piece':'left'},{'op':'rules','piece':'right','rules':{}},
      {'op':'setShade','shade':null},{'op':'setStrip','below':null,'above':null,'repeat':{}})");
  ASSERT_TRUE(without) << without.error().message;
  EXPECT_EQ(without->marker, loose().marker);
}

TEST(Edits, PiecesAreAddedAndRemovedWithTheirShapesAndAttributes) {
  const auto after = edited(loose(), R"({'op':'remove','piece':'right'},
      {'op':'add','piece':{'id':'right','shape':'tri','at':[9,9],'attributes':{'size':42}},
       'shape':{'id':'tri','outline':[[0,0],[0,1],[1,0]],'attributes':{'cut':'twice'}}},
      {'op':'add','piece':{'id':'more','shape':'tri','at':[20,0]}},{'op':'remove','piece':'left'})");
  ASSERT_TRUE(after) << after.error().message;
  ASSERT_EQ(after->marker.pieces.size(), 2U);
  EXPECT_EQ(after->marker.pieces[0].id, "right");
  EXPECT_EQ(after->attributes.pieces[0]["size"], 42);
  EXPECT_TRUE(after->attributes.pieces[1].empty());
  EXPECT_EQ(after->attributes.shapes[1]["cut"], "twice");
  ASSERT_EQ(after->notes.size(), 1U);  // clockwise
  EXPECT_EQ(after->notes[0].field, "/ops/1/shape/outline");
}

TEST(Edits, MistakesPointToTheirOperation) {
  const MarkerFile file = loose();
  using enum ErrorCode;
  expect_error(file, "{'op':'remove','piece':'left'},{'op':'move','piece':'left','at':[0,0]}", kOutOfRange,
               "/ops/1/piece");
  expect_error(file, "{'op':'tilt','piece':'left','to':5},{'op':'tilt','piece':'left','by':1}", kOrientationNotAllowed,
               "/ops/1");
  expect_error(file, "{'op':'setStrip','width':30}", kPieceTooWide, "/ops/0");
  expect_error(file, "{'op':'setSpacing','spacing':500}", kOutOfRange, "/ops/0/spacing");
  expect_error(file, "{'op':'setOverlap','overlap':500}", kOutOfRange, "/ops/0/overlap");
  expect_error(file, "{'op':'overlap','piece':'left','overlap':500}", kOutOfRange, "/ops/0/overlap");
  expect_error(file, "{'op':'setStrip','below':500}", kOutOfRange, "/ops/0/below");
  expect_error(file, "{'op':'setStrip','below':500},{'op':'setStrip','width':120}", kOutOfRange, "/ops/0/below");
  expect_error(file, "{'op':'setStrip','width':120,'margin':90}", kOutOfRange, "/ops/0/margin");
  expect_error(file, "{'op':'setStrip','repeat':{'across':1e300}}", kOutOfRange, "/ops/0/repeat/across");
  expect_error(file, "{'op':'rules','piece':'left','rules':{'match':[1e300,0]}}", kBeyondLattice,
               "/ops/0/rules/match/0");
  expect_error(file, "{'op':'rules','piece':'left','rules':{'fold':true,'below':1}},{'op':'lock','piece':'left'}",
               kOutOfRange, "/ops/0/rules/below");
  expect_error(file, "{'op':'add','piece':{'id':'x','shape':'square','at':[0,0],'rules':{'fold':true,'below':1}}}",
               kOutOfRange, "/ops/0/piece/rules/below");
  expect_error(file, "{'op':'rules','piece':'left','rules':{'zone':true,'quality':0}}", kOutOfRange,
               "/ops/0/rules/quality");
  const std::string part = "{'op':'rules','piece':'left','rules':{'quality':1,'part':";
  expect_error(file, part + "{'outline':[[0,0],[1,0],[0,1000]]}}}", kOutOfRange, "/ops/0/rules/part/outline");
  expect_error(file, part + "{'outline':[[0,0],[1,0],[0,1e300]]}}}", kBeyondLattice, "/ops/0/rules/part/outline");
  expect_error(file, part + "{'outline':[[0,0],[1,0],[0,1]],'quality':1}}}", kOutOfRange, "/ops/0/rules/part/quality");
  expect_error(file, "{'op':'setShade','shade':0}", kOutOfRange, "/ops/0/shade");
  expect_error(file, "{'op':'rules','piece':'left','rules':{'from':9,'to':10}}", kOutOfRange, "/ops/0/rules/to");
  expect_error(file, "{'op':'remove','piece':'left'},{'op':'remove','piece':'right'}", kEmptyMarker, "/ops");
  expect_error(file, "{'op':'add','piece':{'id':'left','shape':'square','at':[0,0]}}", kDuplicateId, "/ops/0/piece/id");
  expect_error(file, "{'op':'add','piece':{'id':'x','shape':'round','at':[0,0]}}", kUnknownShape, "/ops/0/piece/shape");
  expect_error(
      file, "{'op':'add','piece':{'id':'x','shape':'l','at':[0,0]},'shape':{'id':'l','outline':[[0,0],[1,1],[2,2]]}}",
      kZeroArea, "/ops/0/shape/outline");
  expect_error(file, "{'op':'move','piece':'left','at':[1e300,0]}", kBeyondLattice, "/ops/0/at");
  expect_error(file, "{'op':'move','piece':'left'}", kMissingField, "/ops/0/at");
  expect_error(file, "{'op':'rotate','piece':'left','to':1e9}", kOutOfRange, "/ops/0/to");
  expect_error(file, "{'op':'setStrip'}", kMissingField, "/ops/0");
  expect_error(file, "{'op':'lock','piece':'left','until':3}", kUnknownField, "/ops/0/until");
  expect_error(file, "{'piece':'left'}", kMissingField, "/ops/0/op");
  expect_error(file, "7", kWrongType, "/ops/0");
}

TEST(Edits, MovesThatAddUpBeyondTheLatticeAreRefused) {
  std::string ops = "{'op':'move','piece':'left','at':[0,0]}";
  for (int i = 0; i < 2000; ++i) ops += ",{'op':'move','piece':'left','by':[1e4,0]}";
  const auto after = edited(loose(), ops);
  ASSERT_FALSE(after);
  EXPECT_EQ(after.error().code, ErrorCode::kBeyondLattice);
}

TEST(Edits, WhatTheyLeaveCanBeReadAgain) {
  // A piece may lie as far as the strip's width allows, but not reach farther; and no strip becomes too narrow for it.
  Json document = test::native_squares();
  document["resolution"] = 0.001;
  const MarkerFile file = test::read(document);
  const auto width = to_decimal(file.marker.strip.width, file.marker.resolution);
  const auto moved_to = [&](double x) {
    return edited(file, "{'op':'move','piece':'left','at':[" + json::number_text(x) + ",0]}");
  };
  const auto beyond = moved_to(1e5 * width);
  ASSERT_FALSE(beyond);
  EXPECT_EQ(beyond.error().code, ErrorCode::kBeyondLattice);
  const auto halfway = moved_to(5e4 * width);
  ASSERT_TRUE(halfway) << halfway.error().message;
  const auto narrower = edited(*halfway, "{'op':'setStrip','width':" + json::number_text(width / 4) + "}");
  ASSERT_FALSE(narrower);
  EXPECT_EQ(narrower.error().code, ErrorCode::kBeyondLattice);
}

TEST(Moves, LeadFromOneStateToTheOtherAndAreExactAsText) {
  const MarkerFile before = loose();
  const auto after = edited(before, R"({'op':'move','piece':'right','at':[61.0625,3]},
      {'op':'rotate','piece':'right','to':12.34},{'op':'lock','piece':'right','locked':['y']},
      {'op':'buffer','piece':'right','buffer':0.125},{'op':'overlap','piece':'right','overlap':0.5},{'op':'group','piece':'right','group':'g'},{'op':'tilt','piece':'right','to':-1},
      {'op':'rules','piece':'right','rules':{'below':0,'from':0.5,'shade':'B'}})");
  ASSERT_TRUE(after);
  const auto moves = moves_between(before, *after);
  ASSERT_TRUE(moves);
  ASSERT_EQ(moves->size(), 1U);
  EXPECT_EQ(moved(before, *moves).marker, after->marker);
  const auto again = read_moves(test::json(json::to_text(moves_json(after->marker, *moves))), before.marker);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(moved(before, *again).marker, after->marker);
  EXPECT_TRUE(moves_between(before, before)->empty());
}

TEST(Moves, AreNotEnoughForAnythingElse) {
  const MarkerFile before = loose();
  for (const char* ops :
       {"{'op':'remove','piece':'left'}", "{'op':'setStrip','longest':500}", "{'op':'setSpacing','spacing':1}",
        "{'op':'remove','piece':'left'},{'op':'add','piece':{'id':'left','shape':'square','at':[0,0]}}"}) {
    EXPECT_FALSE(moves_between(before, *edited(before, ops))) << ops;
  }
}

TEST(Moves, OfAnotherMarkerAreRefused) {
  const MarkerFile file = loose();
  for (const char* text :
       {"7", "[7]", "[[9,{}]]", R"([[0,{"id":"right","shape":"square","at":[0,0]}]])",
        R"([[0,{"id":"left","shape":"round","at":[0,0]}]])", R"([[0,{"id":"left","shape":"square","at":[1e30,0]}]])"}) {
    EXPECT_FALSE(read_moves(test::json(text), file.marker)) << text;
  }
}

TEST(Changes, AMarkerThatLostPiecesKeepsTheAttributesOfTheOthers) {
  const MarkerFile before = loose();
  Marker less = before.marker;
  less.pieces.erase(less.pieces.begin());
  EXPECT_TRUE(with_marker(before, less).attributes.pieces.at(0).empty());
  less = before.marker;
  less.pieces.pop_back();
  EXPECT_EQ(with_marker(before, less).attributes.pieces.at(0)["bundle"], 7);
}

}  // namespace
}  // namespace selvage::protocol::edits
