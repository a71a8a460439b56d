// ESICUP XML: what is written reads back as the same layout, or a note says what is lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "protocol/files/losses.h"
#include "protocol/files/reading.h"
#include "protocol/files/writing.h"
#include "tests/protocol/formats/samples.h"
#include "tests/protocol/trade/example.h"

namespace selvage {
namespace {

using protocol::files::FileFormat;

std::string nesting_xml(const MarkerFile& file) {
  auto text = protocol::files::write_marker(file, FileFormat::kEsicup);
  if (!text) throw std::runtime_error(text.error().message);
  return *std::move(text);
}

std::size_t times_in(const std::string& text, const std::string& part) {
  std::size_t times = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++times;
  return times;
}

std::vector<std::string> texts_of(const std::vector<Note>& notes) {
  std::vector<std::string> texts;
  for (const Note& note : notes) texts.push_back(note.text);
  return texts;
}

// Every corner of every piece, in lattice units of 1e-9.
std::vector<Polygon> corners_of(const MarkerFile& file) {
  std::vector<Polygon> outlines;
  for (std::uint32_t k = 0; k < file.marker.pieces.size(); ++k) {
    Polygon outline = placed_outline(file.marker, PieceId{k});
    for (Vec& corner : outline) {
      corner = {to_lattice(to_decimal(corner.x, file.marker.resolution), Resolution{-9}),
                to_lattice(to_decimal(corner.y, file.marker.resolution), Resolution{-9})};
    }
    std::sort(outline.begin(), outline.end());
    outlines.push_back(std::move(outline));
  }
  return outlines;
}

MarkerFile strip_of(const std::string& width, const std::string& resolution, const std::string& shapes,
                    const std::string& pieces) {
  return test::read(test::json(R"({"format": "selvage-marker", "version": 1, "resolution": )" + resolution +
                               R"(, "strip": {"width": )" + width + R"(}, "shapes": [)" + shapes + R"(], "pieces": [)" +
                               pieces + "]}"));
}

TEST(EsicupTwoWays, KeepsAllDigitsOfPositions) {
  const std::string kite = R"({"id": "s", "outline": [[0, 0], [0.2151, 0], [0.18093, 0.33]], "flip": true})";
  const MarkerFile narrow = strip_of("1", "1e-9", kite,
                                     R"({"id": "a", "shape": "s", "at": [0.234193883, 0.33]},
                                        {"id": "b", "shape": "s", "at": [0.234084147, 0.33], "flip": true})");
  const std::string star = R"({"id": "s", "tilt_limit": 0.1, "outline": [[17.363, 4.102], [6.2, 17.857],
      [-1.742, 40.885], [-2.969, 5.717], [-17.363, -4.102], [-5.335, -15.363], [1.742, -40.885], [6.12, -11.783]]})";
  const MarkerFile tilted =
      strip_of("150", "1e-7", star, R"({"id": "a", "shape": "s", "at": [95.9868428, 102.7537366], "tilt": 0.1},
                                       {"id": "b", "shape": "s", "at": [91.6558142, 40.8818974], "tilt": 0.1},
                                       {"id": "c", "shape": "s", "at": [70.3673259, 109.1181026], "tilt": 0.1})");
  for (const MarkerFile& file : {narrow, tilted}) {
    ASSERT_TRUE(is_valid(file.marker));
    const MarkerFile back = test::read_text(nesting_xml(file));
    EXPECT_TRUE(is_valid(back.marker));
    EXPECT_EQ(corners_of(back), corners_of(file));
  }
}

TEST(EsicupTwoWays, AnglesAreFrom0To360) {
  const MarkerFile file = strip_of("100", "1e-7", R"({"id": "s", "rotations": [-90, -82.37, 30.1, 360],
                                                      "outline": [[0, 0], [20, 0], [20, 10], [0, 10]]})",
                                   R"({"id": "a", "shape": "s", "at": [0, 40], "rotation": -90},
                                      {"id": "b", "shape": "s", "at": [30, 40], "rotation": -82.37},
                                      {"id": "c", "shape": "s", "at": [60, 40], "rotation": 30.1},
                                      {"id": "d", "shape": "s", "at": [60, 80], "rotation": 360})");
  const std::string text = nesting_xml(file);
  for (const char* angle : {"90", "82.37", "329.9", "0"}) {
    EXPECT_EQ(times_in(text, "angle=\"" + std::string{angle} + "\""), 2U) << angle << '\n' << text;
  }
  const MarkerFile back = test::read_text(text);
  EXPECT_EQ(corners_of(back), corners_of(file));
  EXPECT_EQ(back.marker.shapes[0].rotations, (std::vector<Angle>{Angle::of_degrees(270), Angle::of_degrees(277.63),
                                                                 Angle::of_degrees(30.1), Angle::of_degrees(0)}));
}

TEST(EsicupTwoWays, ReadsSumsOfDecimalsAsDecimals) {
  const std::string text = R"(<nesting><problem><boards><piece id="b"><component idPolygon="p1"/></piece></boards>
      <lot><piece id="s" quantity="1"><component idPolygon="p0" xOffset="0.1" yOffset="0.1"/></piece></lot></problem>
      <polygons>
        <polygon id="p0"><lines><segment x0="0.2" y0="0.2"/><segment x0="0.7" y0="0.2"/><segment x0="0.7" y0="0.7"/>
        </lines></polygon>
        <polygon id="p1"><lines><segment x0="0" y0="0.1"/><segment x0="9" y0="0.1"/><segment x0="9" y0="0.8"/></lines>
        </polygon></polygons>
      <solutions><solution><placement idPiece="s" x="0.3" y="0.2" angle="0"/></solution></solutions></nesting>)";
  const MarkerFile file = test::read_text(text);
  EXPECT_EQ(file.marker.strip.width, to_lattice(0.7, file.marker.resolution));
  EXPECT_EQ(to_decimal(file.marker.pieces[0].at.y, file.marker.resolution), 0.5);
  for (const Note& note : file.notes) EXPECT_EQ(note.text.find("rounded"), std::string::npos) << note.text;
}

TEST(EsicupOut, FreeRotationIsWrittenAsTheAnglesOfThePiecesWithANote) {
  const MarkerFile file = strip_of("100", "1e-7", R"({"id": "s", "rotations": "any", "outline": [[0, 0], [20, 0],
                                                      [20, 10], [0, 10]]}, {"id": "t", "rotations": "any",
                                                      "outline": [[0, 0], [20, 0], [20, 30], [0, 30]]})",
                                   R"({"id": "a", "shape": "s", "at": [0, 40], "rotation": -90},
                                      {"id": "b", "shape": "s", "at": [30, 40], "rotation": 12.5},
                                      {"id": "c", "shape": "s", "at": [60, 40], "rotation": 270})");
  EXPECT_EQ(
      texts_of(losses(file, FileFormat::kEsicup)),
      (std::vector<std::string>{"shapes that may be rotated freely, 1 in all, are written with only the angles at "
                                "which their pieces lie: ESICUP XML lists single angles"}));
  const MarkerFile back = test::read_text(nesting_xml(file));
  EXPECT_EQ(back.marker.shapes[0].rotations, (std::vector<Angle>{Angle::of_degrees(270), Angle::of_degrees(12.5)}));
  EXPECT_EQ(corners_of(back), corners_of(file));
  for (const Note& note : back.notes) EXPECT_EQ(note.text.find("does not list"), std::string::npos) << note.text;
}

TEST(EsicupOut, NotesOverlapAllowancesAndTilts) {
  MarkerFile file = strip_of("100", "1e-7", R"({"id": "s", "tilt_limit": 2, "outline": [[0, 0], [20, 0], [20, 10]]},
                                               {"id": "t", "outline": [[0, 0], [20, 0], [20, 10]]})",
                             R"({"id": "a", "shape": "s", "at": [0, 40]}, {"id": "b", "shape": "t", "at": [0, 80]})");
  const std::string tilts = "tilt limits are left out, 1 in all";
  EXPECT_EQ(texts_of(losses(file, FileFormat::kEsicup)), std::vector<std::string>{tilts});
  file.marker.pieces[1].overlap = to_lattice(0.5, file.marker.resolution);
  const std::string overlaps =
      "overlap allowances, of 0.5 mm at most, are left out: pieces that overlap are not valid when the file is read";
  EXPECT_EQ(texts_of(losses(file, FileFormat::kEsicup)), (std::vector<std::string>{overlaps, tilts}));
  file.marker.pieces[1].overlap.reset();
  file.marker.overlap = to_lattice(0.5, file.marker.resolution);
  EXPECT_EQ(texts_of(losses(file, FileFormat::kEsicup)), (std::vector<std::string>{overlaps, tilts}));
}

TEST(EsicupOut, NotesAResolutionThatItsReaderWillNotChoose) {
  const std::string shape = R"({"id": "s", "rotations": [0, 30], "outline": [[0, 0], [20, 0], [20, 10]]})";
  const auto notes = [&](const char* resolution, const char* rotation) {
    return texts_of(
        losses(strip_of("100", resolution, shape,
                        R"({"id": "a", "shape": "s", "at": [20, 40], "rotation": )" + std::string{rotation} + "}"),
               FileFormat::kEsicup));
  };
  EXPECT_EQ(notes("0.01", "30"),
            (std::vector<std::string>{"ESICUP XML states no resolution: corners of turned pieces, which are rounded to "
                                      "multiples of 0.01 mm, may lie that far away when the file is read"}));
  EXPECT_EQ(notes("0.01", "0"), std::vector<std::string>{});
  EXPECT_EQ(notes("1e-7", "30"), std::vector<std::string>{});
  MarkerFile file = strip_of("100", "1e-7", shape, R"({"id": "a", "shape": "s", "at": [20, 40], "rotation": 30})");
  file.marker.spacing = 1;  // is not written
  file.marker.strip.longest = to_lattice(50'000, file.marker.resolution);
  EXPECT_EQ(texts_of(losses(file, FileFormat::kEsicup)), std::vector<std::string>{});
  file.marker.unit = "in";
  ASSERT_EQ(losses(file, FileFormat::kEsicup).size(), 2U);
  EXPECT_NE(losses(file, FileFormat::kEsicup)[1].text.find("multiples of 1e-07 in"), std::string::npos)
      << losses(file, FileFormat::kEsicup)[1].text;
}

TEST(EsicupOut, WritesWellFormedXmlOfAnyText) {
  MarkerFile file = test::read(test::native_squares());
  file.marker.name = "<b>\x01&\"'\xef\xbf\xbf";
  file.marker.shapes.push_back(file.marker.shapes[0]);
  file.attributes.shapes.push_back(Json::object());
  file.marker.shapes[0].id = "s\x01";
  file.marker.shapes[1].id = "s\x02";
  file.marker.pieces[1].shape = ShapeId{1};
  EXPECT_EQ(
      texts_of(losses(file, FileFormat::kEsicup)),
      (std::vector<std::string>{"3 texts have characters that XML does not have, and which are replaced; the first "
                                "is \"<b>\\u0001&\\\"'\xef\xbf\xbf\""}));
  const std::string text = nesting_xml(file);
  EXPECT_NE(text.find("<name>&lt;b&gt; &amp;"), std::string::npos) << text;
  for (const char c : text) EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n') << static_cast<int>(c);
  EXPECT_EQ(text.find("&#"), std::string::npos) << text;
  EXPECT_EQ(text.find("\xef\xbf\xbf"), std::string::npos);
  const MarkerFile back = test::read_text(text);
  std::set<std::string> ids;
  for (const Shape& shape : back.marker.shapes) ids.insert(shape.id);
  EXPECT_EQ(ids, (std::set<std::string>{"s ", "s  2"}));
  EXPECT_EQ(corners_of(back), corners_of(file));
}

TEST(EsicupOut, MirroredPiecesHaveAnIdOfTheirOwn) {
  const std::string outline = R"("outline": [[0, 0], [20, 0], [20, 10]])";
  const MarkerFile file =
      strip_of("100", "1e-7", R"({"id": "s", "flip": true, )" + outline + R"(}, {"id": "s_L", )" + outline + "}",
               R"({"id": "a", "shape": "s", "at": [0, 40], "flip": true},
                                      {"id": "b", "shape": "s_L", "at": [0, 80]})");
  EXPECT_EQ(corners_of(test::read_text(nesting_xml(file))), corners_of(file));
}

}  // namespace
}  // namespace selvage
