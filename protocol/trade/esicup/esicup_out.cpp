#include <algorithm>
#include <iterator>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <sstream>

#include "protocol/document/xml_text.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/json/json_text.h"
#include "protocol/trade/esicup/esicup.h"
#include "protocol/trade/esicup/esicup_numbers.h"

namespace selvage::protocol::trade::esicup {
namespace {

// A unit as a whole number of steps of a power of ten of a millimetre: 254 tenths for an inch.
struct Steps {
  std::string_view unit;
  Coord count;
  int exponent;
};
constexpr Steps kUnits[] = {{"mm", 1, 0},      {"cm", 1, 1},     {"m", 1, 3},     {"in", 254, -1},
                            {"inch", 254, -1}, {"ft", 3048, -1}, {"yd", 9144, -1}};

const Steps* steps_of(const std::string& unit) {
  const auto* const found =
      std::find_if(std::begin(kUnits), std::end(kUnits), [&](const Steps& one) { return one.unit == unit; });
  return found == std::end(kUnits) ? nullptr : found;
}

class NestingWriter {
 public:
  explicit NestingWriter(const MarkerFile& file) : marker_{file.marker} {}

  std::string write() {
    pugi::xml_node nesting = document_.append_child("nesting");
    nesting.append_attribute("xmlns") = "http://www.fe.up.pt/~esicup/nesting.xsd";
    child(nesting, "name", document::xml_text(marker_.name));
    child(nesting, "author", "Selvage");
    child(nesting, "verticesOrientation", "clockwise");  // counter-clockwise, with y downwards
    child(nesting, "coordinatesOrigin", "up-left");
    count_copies();
    choose_ids();
    pugi::xml_node problem = nesting.append_child("problem");
    write_board(problem.append_child("boards"));
    pugi::xml_node lot = problem.append_child("lot");
    pugi::xml_node polygons = nesting.append_child("polygons");
    const Coord length = length_of(marker_), width = marker_.strip.width;
    write_polygon(polygons, "polygon0", {{0, 0}, {length, 0}, {length, width}, {0, width}}, width);
    std::size_t number = 0;
    for (const auto& [key, copies] : copies_) {
      const std::string polygon = "polygon" + std::to_string(++number);
      const Shape& shape = marker_.shapes[key.first];
      write_lot_piece(lot, key, copies, polygon);
      write_polygon(polygons, polygon, key.second ? transformed(shape.outline, Symmetry{true, 0}) : shape.outline, 0);
    }
    pugi::xml_node solutions = nesting.append_child("solutions");
    if (!marker_.pieces.empty()) write_solution(solutions.append_child("solution"));
    std::ostringstream out;
    document_.save(out, "  ");
    return out.str();
  }

 private:
  using Key = std::pair<std::uint32_t, bool>;  // a shape, flipped or not

  static void child(pugi::xml_node& parent, const char* name, const std::string& text) {
    parent.append_child(name).text() = text.c_str();
  }
  [[nodiscard]] std::string decimal(Coord coord) const {
    const Steps* const steps = steps_of(marker_.unit);
    if (steps == nullptr) return json::number_text(to_decimal(coord, marker_.resolution));
    const int exponent = marker_.resolution.exponent + steps->exponent;
    const double finest = exponent < geometry::kFinestExponent ? 10 : 1;
    return json::number_text(
        to_decimal(coord * steps->count, Resolution{std::max(exponent, geometry::kFinestExponent)}) / finest);
  }
  static Key key_of(const Piece& piece) { return {piece.shape.value, piece.orientation.flip}; }
  static double angle_of(const Piece& piece) {
    return piece.orientation.rotation.degrees + piece.orientation.tilt.degrees;
  }
  static std::string angle_text(double degrees) { return json::number_text(reversed_angle(degrees)); }

  void count_copies() {
    for (const auto* pieces : {&marker_.pieces, &marker_.unplaced}) {
      for (const Piece& piece : *pieces) {
        if (piece.rules.zone) continue;
        ++copies_[key_of(piece)];
        angles_[key_of(piece)].push_back(angle_of(piece));
      }
    }
  }

  // Ids that differ, although one may be another's with the mark of a mirrored shape, and those of two may contain
  // different characters that XML does not have.
  void choose_ids() {
    std::set<std::string> taken;
    for (const auto& [key, copies] : copies_) {
      const std::string wanted = document::xml_text(marker_.shapes[key.first].id) + (key.second ? "_L" : "");
      std::string id = wanted;
      for (int number = 2; !taken.insert(id).second; ++number) id = wanted + " " + std::to_string(number);
      ids_.emplace(key, std::move(id));
    }
  }

  // Those that the shape allows; if it allows any, those of its pieces.
  [[nodiscard]] std::vector<std::string> angles_of(const Key& key) const {
    std::vector<double> degrees;
    for (const Angle angle : marker_.shapes[key.first].rotations) degrees.push_back(angle.degrees);
    std::vector<std::string> angles;
    std::set<std::string> listed;
    for (const double angle : degrees.empty() ? angles_.at(key) : degrees) {
      if (listed.insert(angle_text(angle)).second) angles.push_back(angle_text(angle));
    }
    return angles;
  }

  void write_board(pugi::xml_node boards) {
    pugi::xml_node board = boards.append_child("piece");
    board.append_attribute("id") = "board0";
    board.append_attribute("quantity") = 1;
    write_component(board, "polygon0");
  }

  static void write_component(pugi::xml_node& piece, const std::string& polygon) {
    pugi::xml_node component = piece.append_child("component");
    component.append_attribute("idPolygon") = polygon.c_str();
    for (const char* key : {"type", "xOffset", "yOffset"}) component.append_attribute(key) = 0;
  }

  void write_lot_piece(pugi::xml_node& lot, const Key& key, int copies, const std::string& polygon) {
    pugi::xml_node piece = lot.append_child("piece");
    piece.append_attribute("id") = ids_.at(key).c_str();
    piece.append_attribute("quantity") = copies;
    pugi::xml_node orientation = piece.append_child("orientation");
    for (const std::string& angle : angles_of(key)) {
      orientation.append_child("enumeration").append_attribute("angle") = angle.c_str();
    }
    write_component(piece, polygon);
  }

  // y becomes base - y.
  void write_polygon(pugi::xml_node& polygons, const std::string& id, const Polygon& outline, Coord base) {
    pugi::xml_node polygon = polygons.append_child("polygon");
    polygon.append_attribute("id") = id.c_str();
    polygon.append_attribute("nVertices") = static_cast<unsigned>(outline.size());
    pugi::xml_node lines = polygon.append_child("lines");
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Vec from = outline[k], to = outline[(k + 1) % outline.size()];
      pugi::xml_node segment = lines.append_child("segment");
      segment.append_attribute("n") = static_cast<unsigned>(k + 1);
      segment.append_attribute("x0") = decimal(from.x).c_str();
      segment.append_attribute("x1") = decimal(to.x).c_str();
      segment.append_attribute("y0") = decimal(base - from.y).c_str();
      segment.append_attribute("y1") = decimal(base - to.y).c_str();
    }
  }

  void write_solution(pugi::xml_node solution) {
    for (const Piece& piece : marker_.pieces) {
      if (piece.rules.zone) continue;
      pugi::xml_node placement = solution.append_child("placement");
      placement.append_attribute("angle") = angle_text(angle_of(piece)).c_str();
      placement.append_attribute("boardNumber") = 1;
      placement.append_attribute("idBoard") = "board0";
      placement.append_attribute("idPiece") = ids_.at(key_of(piece)).c_str();
      placement.append_attribute("mirror") = "none";
      placement.append_attribute("x") = decimal(piece.at.x).c_str();
      placement.append_attribute("y") = decimal(marker_.strip.width - piece.at.y).c_str();
    }
  }

  const Marker& marker_;
  std::map<Key, int> copies_;
  std::map<Key, std::vector<double>> angles_;  // of the copies, degrees
  std::map<Key, std::string> ids_;
  pugi::xml_document document_;
};

}  // namespace

bool converts_unit(const Marker& marker) {
  const Steps* const steps = steps_of(marker.unit);
  return steps != nullptr && steps->unit != "mm";
}

std::optional<Note> unit_note(const Marker& marker) {
  const Steps* const steps = steps_of(marker.unit);
  if (steps != nullptr && steps->unit == "mm") return std::nullopt;
  const std::string unit = json::shortened(Json(marker.unit));
  return Note{
      "", "ESICUP XML states no unit: " +
              (steps != nullptr ? "the numbers are converted from " + unit + " to mm" : "the numbers are in " + unit)};
}

std::string esicup_file(const MarkerFile& file) {
  return NestingWriter{file}.write();
}

}  // namespace selvage::protocol::trade::esicup
