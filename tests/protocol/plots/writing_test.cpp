// Every format that is written: it is read back, or its content is checked.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/marker/validity.h"
#include "protocol/document/annotations.h"
#include "protocol/edits/cloth.h"
#include "protocol/files/losses.h"
#include "protocol/files/writing.h"
#include "tests/protocol/formats/samples.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::files::FileFormat;
using protocol::files::format_of_name;
using protocol::files::losses;
using protocol::files::read_file;
using protocol::files::write_marker;
using test::read_example;

std::string written(const MarkerFile& file, FileFormat format) {
  auto text = write_marker(file, format);
  if (!text) throw std::runtime_error(text.error().message);
  return *std::move(text);
}

std::size_t count_of(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

// A marker with everything that a nest must keep: flips, tilts, locks, a group, a buffer, a margin, overlap allowances,
// rules.
MarkerFile rich_marker() {
  return test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "t\u00eate \u65e0", "unit": "mm",
    "strip": {"width": 1500.5, "margin": 2, "longest": 9000, "below": 1.5, "repeat": {"along": 64.5, "across": 48, "phase": [-10, 0]}, "tube": true}, "spacing": 0.5, "overlap": 1.25, "shade": 2000,
    "shapes": [
      {"id": "FRONT/S", "outline": [[0, 0], [300.123457, 10], [290, 200], [5, 180]], "rotations": [0, 180], "flip": true,
       "tilt_limit": 3,
       "attributes": {"size": "S", "material": "SHL", "annotations": {
         "notches": [{"kind": "v", "at": [150, 5], "depth": 4, "width": 2, "angle": 90}],
         "drills": [[100, 100]],
         "lines": [{"kind": "sew", "closed": true, "points": [[10, 10], [280, 20], [270, 180]]},
                   {"kind": "grain", "points": [[50, 90], [250, 90]]}],
         "texts": [{"text": "CF", "at": [20, 20], "height": 8, "angle": 30}]}}},
      {"id": "free", "outline": [[0, 0], [100, 0], [0, 50]], "rotations": "any"}],
    "pieces": [
      {"id": "a", "shape": "FRONT/S", "at": [10, 10], "overlap": 0.5, "rules": {"below": 0, "to": 1400.5, "match": [150, -5], "matchSet": "M", "shade": "S-A"}, "attributes": {"bundle": "S-A"}},
      {"id": "b", "shape": "FRONT/S", "at": [700, 300], "rotation": 180, "flip": true, "tilt": 1.5, "locked": ["x"], "rules": {"nap": "down", "quality": 2, "part": {"outline": [[5, 180], [0, 0], [100.5, 10]], "quality": 1}}},
      {"id": "c", "shape": "free", "at": [900, 700], "rotation": 37.25, "group": "g", "buffer": 1.5,
       "rules": {"above": 3, "from": 2, "shade": "S-A"}},
      {"id": "d", "shape": "free", "at": [1200, 700], "group": "g", "locked": true}]
  })"));
}

TEST(DxfNest, ReadsBackAsTheSameMarker) {
  for (const MarkerFile& file :
       {rich_marker(), read_example("polypattern_like.dxf"), read_example("gemini_like.cut")}) {
    const auto back = read_file(written(file, FileFormat::kDxf));
    ASSERT_TRUE(back) << back.error().field << ": " << back.error().message;
    EXPECT_EQ(back->marker, file.marker);
    for (std::size_t k = 0; k < file.marker.shapes.size(); ++k) {
      auto before = protocol::document::annotations_of(file.attributes.shapes[k]);
      auto after = protocol::document::annotations_of(back->attributes.shapes[k]);
      EXPECT_EQ(after.notches, before.notches);
      EXPECT_EQ(after.drills, before.drills);
      EXPECT_EQ(after.texts, before.texts);
      EXPECT_EQ(after.lines.size(), before.lines.size());
    }
  }
}

// A flaw of the cloth, which has a shape of its own, does not change what is cut.
TEST(Writing, ZonesAreLeftOut) {
  const MarkerFile file = rich_marker();
  MarkerFile flawed = file;
  flawed.marker.shapes.push_back({.id = "flaw", .outline = {{0, 0}, {1000, 0}, {0, 1000}}, .tilt_limit = {}});
  flawed.attributes.shapes.push_back(Json::object());
  flawed.marker.pieces.push_back(file.marker.pieces[3]);
  Piece& zone = flawed.marker.pieces.back();
  zone = {.id = "flaw", .shape = {2}, .orientation = {}, .at = {}, .locked = true, .rules = {.zone = true}};
  flawed.attributes.pieces.push_back(Json::object());
  for (const FileFormat format :
       {FileFormat::kDxf, FileFormat::kHpgl, FileFormat::kCut, FileFormat::kPdf, FileFormat::kEsicup}) {
    EXPECT_EQ(written(flawed, format), written(file, format));
  }
}

// A square with a square hole, which is open.
MarkerFile open_frame(bool with_cut_outs) {
  MarkerFile file = test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "", "strip": {"width": 200},
    "shapes": [{"id": "frame", "outline": [[0, 0], [100, 0], [100, 100], [0, 100]],
                "holes": [[[20, 20], [80, 20], [80, 80], [20, 80]]], "rotations": [30]}],
    "pieces": [{"id": "f", "shape": "frame", "at": [60, 0], "rotation": 30}]})"));
  auto open = protocol::edits::with_cloth(std::move(file), {.open_holes = true});
  if (!open) throw std::runtime_error(open.error().message);
  if (!with_cut_outs) open->attributes.shapes[0] = Json::object();
  return *std::move(open);
}

TEST(Writing, OpenHolesAreCutOnceAndWithoutTheirSlits) {
  for (const bool with_cut_outs : {true, false}) {
    const MarkerFile frame = open_frame(with_cut_outs);
    EXPECT_EQ(count_of(written(frame, FileFormat::kCut), "M14*"), 2U);  // the hole and the outline
    EXPECT_EQ(count_of(written(frame, FileFormat::kHpgl), "PD"), 3U);   // and the frame of the sheet
    EXPECT_EQ(count_of(written(frame, FileFormat::kSvg), "ZM"), 1U);    // two rings of one path
  }
}

// A frame around a frame around a square, drawn from the outside to the inside, and a square beside them.
MarkerFile nested_frames() {
  MarkerFile file = test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "", "strip": {"width": 400},
    "shapes": [{"id": "large", "outline": [[0, 0], [400, 0], [400, 400], [0, 400]],
                "holes": [[[50, 50], [350, 50], [350, 350], [50, 350]]]},
               {"id": "small", "outline": [[0, 0], [200, 0], [200, 200], [0, 200]],
                "holes": [[[40, 40], [160, 40], [160, 160], [40, 160]]]},
               {"id": "square", "outline": [[0, 0], [40, 0], [40, 40], [0, 40]]}],
    "pieces": [{"id": "outer", "shape": "large", "at": [0, 0]}, {"id": "inner", "shape": "small", "at": [100, 100]},
               {"id": "middle", "shape": "square", "at": [180, 180]},
               {"id": "beside", "shape": "square", "at": [400, 0]}]})"));
  auto open = protocol::edits::with_cloth(std::move(file), {.open_holes = true});
  if (!open) throw std::runtime_error(open.error().message);
  return *std::move(open);
}

TEST(Cut, WhatLiesInAHoleIsCutBeforeThePieceAroundIt) {
  const std::string text = written(nested_frames(), FileFormat::kCut);
  const auto place = [&](const char* label) { return text.find("M31*" + std::string{label} + "*"); };
  ASSERT_NE(place("beside"), std::string::npos);
  ASSERT_NE(place("outer"), std::string::npos);
  EXPECT_LT(place("middle"), place("inner"));
  EXPECT_LT(place("inner"), place("outer"));
}

// Whether the spot lies on the cloth of the outer frame, at least this far from its edges.
bool on_outer_frame(double x, double y, double least) {
  const double from_outside = std::min({x, y, 400 - x, 400 - y});
  return from_outside >= least && from_outside <= 50 - least;
}

TEST(Writing, TheLabelOfAPieceWithAHoleLiesOnItsCloth) {
  const std::string cut = written(nested_frames(), FileFormat::kCut);
  const std::size_t label = cut.find("M31*outer*"), begin = cut.rfind('X', label);
  const double x = std::stod(cut.substr(begin + 1)), y = std::stod(cut.substr(cut.find('Y', begin) + 1));
  EXPECT_TRUE(on_outer_frame(x / 10, y / 10, 10)) << x << " " << y;

  const std::string plot = written(nested_frames(), FileFormat::kHpgl);
  const std::size_t pen = plot.rfind("PU", plot.find("LBouter"));
  const double left = std::stod(plot.substr(pen + 2)), low = std::stod(plot.substr(plot.find(',', pen) + 1));
  EXPECT_TRUE(on_outer_frame(left / 40, low / 40, 5)) << left << " " << low;
}

TEST(DxfNest, KeepsTheAttributesForWhichItHasPlaces) {
  MarkerFile file = rich_marker();
  file.attributes.whole =
      test::json(R"({"author": "A. Schneider", "product": "blouse", "version": "2", "date": "7-3"})");
  file.attributes.shapes[0]["name"] = "Vorderteil";
  file.attributes.pieces[0] =
      test::json(R"({"bundle": "S-A", "size": "S", "style": "ST", "side": "left", "label": "FRONT 1"})");
  const auto back = read_file(written(file, FileFormat::kDxf));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->attributes.whole, file.attributes.whole);
  EXPECT_EQ(back->attributes.pieces, file.attributes.pieces);
  EXPECT_EQ(back->attributes.shapes[0]["name"], Json("Vorderteil"));
  EXPECT_EQ(losses(file, FileFormat::kDxf), std::vector<Note>{});
  EXPECT_TRUE(read_file(written(rich_marker(), FileFormat::kDxf))->attributes.whole.empty());
}

TEST(DxfNest, NotesTheAttributesThatItLoses) {
  MarkerFile file = rich_marker();
  file.attributes.whole["lot"] = 7;
  file.attributes.shapes[1]["size"] = 40;
  file.attributes.pieces[0]["colour"] = "red";
  file.attributes.pieces[1]["batch"] = "9";
  const std::vector<Note> notes = losses(file, FileFormat::kDxf);
  ASSERT_EQ(notes.size(), 3U);
  EXPECT_EQ(notes[0].text, "DXF has no place for these attributes of the marker: \"lot\"");
  EXPECT_EQ(notes[1].text, "DXF has no place for these attributes of the shapes: \"size\"");
  EXPECT_EQ(notes[2].text, "DXF has no place for these attributes of the pieces: \"batch\", \"colour\"");
}

TEST(DxfNest, ReadsBackWithAnyIds) {
  const std::vector<std::string> ids{
      "",         " ",   "a",      "a ",         " a",         "a\nb",         "a\tb", "\"a\"", "\"",
      "\\U+00E4", "a\\", "\u00e4", "\U0001F600", "\U0001F601", "\u6807\u8bb0", "a: b", "\x7f"};
  MarkerFile file = rich_marker();
  file.marker.pieces.resize(1);
  file.attributes.pieces.resize(1);
  file.marker.shapes.clear();
  file.attributes.shapes.clear();
  const Piece first = file.marker.pieces[0];
  file.marker.pieces.clear();
  for (std::uint32_t k = 0; k < ids.size(); ++k) {
    const Coord side = to_lattice(10 + k, file.marker.resolution);
    file.marker.shapes.push_back({.id = ids[k], .outline = {{0, 0}, {side, 0}, {0, side}}, .tilt_limit = {}});
    file.attributes.shapes.push_back(Json::object());
    file.marker.pieces.push_back(first);
    Piece& piece = file.marker.pieces.back();
    piece.id = ids[k];
    piece.shape = {k};
    piece.at = {side + to_lattice(40 * k, file.marker.resolution), 0};
    piece.rules = {};
    piece.rules.shade = piece.group = ids[k];
  }
  file.attributes.pieces.assign(ids.size(), Json::object());
  const auto back = read_file(written(file, FileFormat::kDxf));
  ASSERT_TRUE(back) << back.error().field << ": " << back.error().message;
  EXPECT_EQ(back->marker, file.marker);
  const std::vector<Note> notes = losses(file, FileFormat::kDxf);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_TRUE(notes[0].text.starts_with("20 ids are written in quotes")) << notes[0].text;
}

TEST(Losses, AreLettersThatTheFormatDoesNotHave) {
  MarkerFile file = test::read(test::native_squares());
  for (const FileFormat format : {FileFormat::kCut, FileFormat::kHpgl, FileFormat::kPdf, FileFormat::kReport})
    EXPECT_EQ(losses(file, format), std::vector<Note>{});
  file.marker.pieces[0].id = "\u00c4rmel";
  EXPECT_NE(written(file, FileFormat::kPdf).find("(\\304rmel)"), std::string::npos);
  EXPECT_EQ(losses(file, FileFormat::kPdf), std::vector<Note>{});
  for (const FileFormat format : {FileFormat::kCut, FileFormat::kHpgl}) {
    ASSERT_EQ(losses(file, format).size(), 1U);
    EXPECT_NE(losses(file, format)[0].text.find("which are replaced; the first is \"\u00c4rmel\""), std::string::npos);
  }
  file.marker.pieces[1].id = "\u6807\u8bb0";
  ASSERT_EQ(losses(file, FileFormat::kPdf).size(), 1U);
  EXPECT_TRUE(losses(file, FileFormat::kPdf)[0].text.starts_with("1 text has characters that PDF does not have"));
}

TEST(Esicup, IsInMillimetres) {
  MarkerFile file = test::read(test::native_squares());
  EXPECT_EQ(losses(file, FileFormat::kEsicup), std::vector<Note>{});
  const MarkerFile millimetres = file;
  file.marker.unit = "in";
  const auto back = read_file(written(file, FileFormat::kEsicup));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->marker.unit, "mm");
  EXPECT_EQ(to_decimal(back->marker.strip.width, back->marker.resolution),
            25.4 * to_decimal(millimetres.marker.strip.width, millimetres.marker.resolution));
  ASSERT_EQ(losses(file, FileFormat::kEsicup).size(), 1U);
  EXPECT_EQ(losses(file, FileFormat::kEsicup)[0].text,
            "ESICUP XML states no unit: the numbers are converted from \"in\" to mm");
  file.marker.unit = "ell";
  EXPECT_EQ(losses(file, FileFormat::kEsicup)[0].text, "ESICUP XML states no unit: the numbers are in \"ell\"");
}

TEST(DxfNest, IsInInchesForAMarkerInInches) {
  MarkerFile file = rich_marker();
  file.marker.unit = "in";
  const auto back = read_file(written(file, FileFormat::kDxf));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->marker, file.marker);
  file.marker.unit = "ell";
  EXPECT_EQ(write_marker(file, FileFormat::kDxf).error().code, ErrorCode::kOutOfRange);
}

TEST(DxfNest, HasABlockForEachShapeAndAMirroredOneForFlippedPieces) {
  const std::string text = written(rich_marker(), FileFormat::kDxf);
  EXPECT_EQ(count_of(text, "\nBLOCK\n"), 3U);
  EXPECT_EQ(count_of(text, "\nINSERT\n"), 4U);
  EXPECT_EQ(text.find("\n41\n"), std::string::npos);  // no scales
  EXPECT_NE(text.find("t\\U+00EAte \\U+65E0"), std::string::npos);
}

TEST(Hpgl, DrawsEveryOutlineInPositiveUnits) {
  const MarkerFile file = read_example("polypattern_like.dxf");
  const std::string text = written(file, FileFormat::kHpgl);
  EXPECT_TRUE(text.starts_with("IN;CO\"ASTMD6959-03\";SP1;"));
  EXPECT_NE(text.find("FRONT R1\x03"), std::string::npos);
  EXPECT_EQ(text.find("PU-"), std::string::npos);
  EXPECT_EQ(text.find("PD-"), std::string::npos);
}

// A reader takes the first label in a piece for its name.
TEST(Hpgl, TheNameOfAPieceComesBeforeTheTextsDrawnOnIt) {
  const auto back = read_file(written(rich_marker(), FileFormat::kHpgl));
  ASSERT_TRUE(back) << back.error().message;
  std::vector<std::string> ids;
  for (const Piece& piece : back->marker.pieces) ids.push_back(piece.id);
  std::sort(ids.begin(), ids.end());
  EXPECT_EQ(ids, (std::vector<std::string>{"a S-A", "b", "c", "d"}));
}

TEST(Pdf, OnePageAtFullSizeHasAUserUnitWhenItIsLong) {
  MarkerFile file = read_example("polypattern_like.dxf");
  EXPECT_EQ(written(file, FileFormat::kPdf).find("/UserUnit"), std::string::npos);
  file.marker.pieces.back().at.x += to_lattice(9000, file.marker.resolution);
  const std::string text = written(file, FileFormat::kPdf);
  EXPECT_NE(text.find("/UserUnit 2"), std::string::npos);
  EXPECT_EQ(count_of(text, "/Type /Page "), 1U);
}

TEST(Pdf, TilesCoverTheMarker) {
  const MarkerFile file = read_example("polypattern_like.dxf");  // of 1500 mm
  const double length = to_decimal(length_of(file.marker), file.marker.resolution);
  const auto columns = static_cast<std::size_t>(std::ceil(length / 190)), rows = std::size_t{6};
  EXPECT_EQ(count_of(written(file, FileFormat::kPdfTiles), "/Type /Page "), columns * rows);
}

// Every offset in the table of objects leads to its object.
TEST(Pdf, TableOfObjectsIsRight) {
  for (const FileFormat format : {FileFormat::kPdf, FileFormat::kPdfTiles, FileFormat::kReport}) {
    const std::string text = written(read_example("polypattern_like.dxf"), format);
    const std::size_t table = std::stoul(text.substr(text.find("startxref\n") + 10));
    ASSERT_EQ(text.substr(table, 5), "xref\n");
    const std::size_t count = std::stoul(text.substr(table + 7));
    const std::size_t first = text.find('\n', table + 5) + 1;
    for (std::size_t k = 1; k < count; ++k) {
      const std::size_t offset = std::stoul(text.substr(first + 20 * k, 10));
      const std::string head = std::to_string(k) + " 0 obj";
      EXPECT_EQ(text.substr(offset, head.size()), head);
    }
  }
}

// Two pieces end to end: their contact and those with the edges hold the length.
TEST(Report, ListsTheCriticalPath) {
  MarkerFile file = test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "A17", "strip": {"width": 100},
    "shapes": [{"id": "s", "outline": [[0, 0], [40, 0], [40, 100], [0, 100]]}],
    "pieces": [{"id": "FRONT", "shape": "s", "at": [0, 0], "attributes": {"bundle": "M-A", "size": "M"}},
               {"id": "BACK", "shape": "s", "at": [40, 0], "attributes": {"bundle": "M-B", "size": "M"}}]})"));
  const std::string text = written(file, FileFormat::kReport);
  for (const char* line : {"(FRONT - left edge, 1)", "(FRONT - BACK, 1)", "(BACK - right edge, 1)", "ratio 2 x M)"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  file.marker.pieces[1].at.x -= 1;
  EXPECT_NE(written(file, FileFormat::kReport).find("(none: the marker is not valid)"), std::string::npos);
}

TEST(Report, CountsWhatDoesNotFit) {
  MarkerFile file = test::read(test::json(R"({
    "format": "selvage-marker", "version": 1, "name": "", "strip": {"width": 100},
    "shapes": [{"id": "s", "outline": [[0, 0], [1, 0], [1, 1], [0, 1]]}],
    "pieces": [{"id": "p", "shape": "s", "at": [0, 0]}]})"));
  const Piece first = file.marker.pieces[0];
  const Coord unit = to_lattice(1, file.marker.resolution);
  for (int k = 1; k <= 1000; ++k) {
    file.marker.pieces.push_back(first);
    file.marker.pieces.back().id = "p" + std::to_string(k);
    file.marker.pieces.back().at = {unit * (k / 100), unit * (k % 100)};
    file.attributes.pieces.push_back(Json::object());
  }
  const std::string text = written(file, FileFormat::kReport);
  EXPECT_NE(text.find("(left out: the marker has more than 1000 pieces)"), std::string::npos);
  const std::size_t more = text.find(" more)");
  ASSERT_NE(more, std::string::npos);
  const std::size_t left_out = std::stoul(text.substr(text.rfind("(and ", more) + 5));
  EXPECT_EQ(left_out + count_of(text, "(1 x p"), 1001U);
}

TEST(Esicup, ReadsBackWithTheSameOutlinesInTheSamePlaces) {
  for (const MarkerFile& file : {read_example("polypattern_like.dxf"), read_example("gemini_like.cut")}) {
    const auto back = read_file(written(file, FileFormat::kEsicup));
    ASSERT_TRUE(back) << back.error().message;
    ASSERT_EQ(back->marker.pieces.size(), file.marker.pieces.size());
    EXPECT_EQ(back->marker.strip.width, file.marker.strip.width);
    for (std::uint32_t k = 0; k < file.marker.pieces.size(); ++k) {
      Polygon before = placed_outline(file.marker, PieceId{k}), after = placed_outline(back->marker, PieceId{k});
      std::sort(before.begin(), before.end());
      std::sort(after.begin(), after.end());
      EXPECT_EQ(after, before);
    }
  }
}

TEST(Svg, DrawsAnnotations) {
  const std::string text = written(rich_marker(), FileFormat::kSvg);
  EXPECT_EQ(count_of(text, "class=\"notch\""), 2U);
  EXPECT_EQ(count_of(text, "class=\"drill\""), 2U);
  EXPECT_EQ(count_of(text, "class=\"inner sew\""), 2U);
}

TEST(NativeForm, KeepsAnnotations) {
  const MarkerFile file = read_example("polypattern_like.dxf");
  const auto back = read_file(written(file, FileFormat::kNative));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->marker, file.marker);
  EXPECT_EQ(back->attributes.shapes, file.attributes.shapes);
}

TEST(FormatOfName, IsTheSuffix) {
  EXPECT_EQ(format_of_name("a.DXF", FileFormat::kNative), FileFormat::kDxf);
  EXPECT_EQ(format_of_name("a.b/c.plt", FileFormat::kNative), FileFormat::kHpgl);
  EXPECT_EQ(format_of_name("a.json", FileFormat::kSparrow), FileFormat::kSparrow);
  EXPECT_EQ(format_of_name("a.json", FileFormat::kSvg), FileFormat::kNative);
  EXPECT_EQ(format_of_name("a", FileFormat::kNative), std::nullopt);
}

}  // namespace
}  // namespace selvage
