#include "protocol/edits/cloth.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "core/geometry/orientation.h"
#include "core/geometry/polygon.h"
#include "core/outline/enclosed/slit.h"
#include "core/outline/set_operations.h"
#include "protocol/document/annotations.h"

namespace selvage::protocol::edits {
namespace {

class ClothMaker {
 public:
  explicit ClothMaker(MarkerFile file) : file_{std::move(file)}, of_zone_(file_.marker.shapes.size()) {
    for (const Piece& piece : file_.marker.pieces) {
      if (piece.rules.zone) of_zone_[piece.shape.value] = true;
    }
  }

  Result<MarkerFile> run(const Cloth& cloth) {
    set_strip(cloth);
    if (cloth.blocks && !mistake_) make_blocks(*cloth.blocks);
    if (cloth.open_holes.value_or(false) && !mistake_) open_holes();
    if (cloth.piece_rules && !mistake_) set_rules(*cloth.piece_rules);
    if (cloth.shade && !mistake_) set_shade(*cloth.shade);
    if (cloth.nap_direction && !mistake_) set_nap(*cloth.nap_direction);
    if (cloth.zones && !mistake_) add_zones(*cloth.zones);
    if (mistake_) return mistake_.error();
    auto made = make_marker(std::move(file_.marker));
    if (!made) return made.error();
    file_.marker = *std::move(made);
    return std::move(file_);
  }

 private:
  [[nodiscard]] Resolution resolution() const { return file_.marker.resolution; }
  // Notes a mistake, and returns false, for lengths beyond the lattice.
  bool fits(bool on_lattice, const std::string& field) {
    if (!on_lattice)
      mistake_.add(ErrorCode::kBeyondLattice,
                   "a length reaches beyond the lattice; shorter ones, or a coarser resolution, are allowed", field);
    return on_lattice;
  }
  template <class To>
  void set_distance(To& to, const std::optional<double>& given, const std::string& field) {
    if (given && fits(geometry::fits_lattice(*given, resolution()), field))
      to = formats::spacing_on_lattice(*given, resolution());
  }

  void set_strip(const Cloth& cloth) {
    Strip& strip = file_.marker.strip;
    set_distance(strip.margin, cloth.margin, "/margin");
    set_distance(strip.below, cloth.margin_below, "/marginBelow");
    set_distance(strip.above, cloth.margin_above, "/marginAbove");
    formats::DecimalRepeat repeat = formats::decimal_repeat(strip.repeat, resolution());
    if (cloth.repeat_along) repeat.along = cloth.repeat_along;
    if (cloth.repeat_across) repeat.across = cloth.repeat_across;
    if (cloth.repeat_phase) repeat.phase = cloth.repeat_phase;
    const auto beyond = formats::beyond_lattice(repeat, resolution());
    const std::string field = !beyond ? "" : *beyond == "/along" ? "Along" : *beyond == "/across" ? "Across" : "Phase";
    if (fits(!beyond, "/repeat" + field)) strip.repeat = formats::repeat_on_lattice(repeat, resolution());
    strip.tube = cloth.tube.value_or(strip.tube);
  }

  void make_blocks(const std::vector<BlocksOfShape>& given) {
    const std::vector<Shape>& shapes = file_.marker.shapes;
    std::unordered_map<std::string_view, std::size_t> numbers;
    for (std::size_t k = 0; k < shapes.size(); ++k) numbers.emplace(shapes[k].id, k);
    std::vector<bool> made(shapes.size());
    for (std::size_t k = 0; k < given.size() && !mistake_; ++k) {
      const std::string field = "/blocks/" + std::to_string(k);
      if (!given[k].shape) {
        make_blocks(given[k], 0, shapes.size(), made, field);
      } else if (const auto found = numbers.find(*given[k].shape); found != numbers.end()) {
        make_blocks(given[k], found->second, found->second + 1, made, field);
      } else {
        mistake_.add(ErrorCode::kOutOfRange,
                     json::shortened(Json(*given[k].shape)) + " is not the id of a shape; the id of one of its " +
                         std::to_string(shapes.size()) + " shapes is allowed",
                     field + "/shape");
      }
    }
  }
  // Those of the shapes from `first` to before `end`; `made`: the shapes that have theirs.
  void make_blocks(const BlocksOfShape& blocks, std::size_t first, std::size_t end, std::vector<bool>& made,
                   const std::string& field) {
    const auto length = [&](double given, const char* side) {
      const bool valid = fits(geometry::fits_lattice(given, resolution()), field + side);
      return valid ? formats::spacing_on_lattice(given, resolution()) : Coord{0};
    };
    const Box by{{-length(blocks.left, "/left"), -length(blocks.below, "/below")},
                 {length(blocks.right, "/right"), length(blocks.above, "/above")}};
    for (std::size_t k = first; k < end && !mistake_; ++k) {
      Shape& shape = file_.marker.shapes[k];
      if (made[k]) {
        mistake_.add(ErrorCode::kOutOfRange,
                     json::shortened(Json(shape.id)) + " has a block already; one for each shape is allowed",
                     field + (blocks.shape ? "/shape" : ""));
        return;
      }
      made[k] = true;
      if (!of_zone_[k]) make_block(shape, file_.attributes.shapes[k], by, field);
    }
    if (!file_.marker.pieces.empty() && by != Box{})
      file_.notes.push_back({field, "the blocks may overlap where they lie: nest or separate them"});
  }
  // The drafted outline becomes a line inside the block.
  void make_block(Shape& shape, Json& attributes, const Box& by, const std::string& field) {
    document::Annotations annotations = document::annotations_of(attributes);
    document::DrawnLine drafted{document::LineKind::kInternal, true, {}};
    for (const Vec v : shape.outline)
      drafted.points.push_back({to_decimal(v.x, resolution()), to_decimal(v.y, resolution())});
    auto block = clean_polygon(outline::widened(shape.outline, by));
    if (!block) {
      mistake_.add(block.error().code, block.error().message, field);
      return;
    }
    shape.outline = std::move(block->polygon);
    annotations.lines.push_back(std::move(drafted));
    attributes["annotations"] = document::annotations_json(annotations);
  }
  void open_holes() {
    bool any = false;
    std::unordered_set<std::string> opened;  // the numbers of the shapes
    std::vector<Note> closed;
    for (std::size_t k = 0; k < file_.marker.shapes.size(); ++k) {
      Shape& shape = file_.marker.shapes[k];
      const std::vector<Polygon> holes = holes_of(file_.attributes.shapes[k]);
      any = any || !holes.empty();
      if (holes.empty() || of_zone_[k] || !outline::enclosed::without_slits(shape.outline).holes.empty()) continue;
      if (auto open = outline::enclosed::with_open_holes(shape.outline, holes)) {
        shape.outline = *std::move(open);
        opened.insert(std::to_string(k));
      } else {
        closed.push_back({"/openHoles", "the holes of " + json::shortened(Json(shape.id)) +
                                            " stay filled: they touch or cross the outline or each other, or are "
                                            "too small for the resolution"});
      }
    }
    std::erase_if(file_.notes, [&](const Note& note) { return is_of_holes(note.field, opened); });
    file_.notes.insert(file_.notes.end(), closed.begin(), closed.end());
    if (!any) file_.notes.push_back({"/openHoles", "no shape has a hole"});
  }
  // Whether a note is one of those that say that the holes of one of these shapes are treated as filled.
  [[nodiscard]] static bool is_of_holes(std::string_view field, const std::unordered_set<std::string>& shapes) {
    constexpr std::pair<std::string_view, std::string_view> kFields[] = {{"/shapes/", "/holes"},
                                                                         {"/items/", "/shape/data/inner"}};
    return std::any_of(std::begin(kFields), std::end(kFields), [&](const auto& around) {
      if (!field.ends_with(around.second)) return false;
      const std::string_view rest = field.substr(0, field.size() - around.second.size());
      const std::size_t number = rest.rfind('/') + 1;
      return rest.substr(0, number).ends_with(around.first) && shapes.contains(std::string{rest.substr(number)});
    });
  }
  [[nodiscard]] std::vector<Polygon> holes_of(const Json& attributes) const {
    std::vector<Polygon> holes;
    for (const document::DrawnLine& line : document::annotations_of(attributes).lines) {
      if (line.kind != document::LineKind::kCutOut || !line.closed) continue;
      const bool fit = std::all_of(line.points.begin(), line.points.end(), [this](const document::Spot& spot) {
        return geometry::fits_lattice(spot.x, resolution()) && geometry::fits_lattice(spot.y, resolution());
      });
      std::vector<Vec> corners;
      for (const document::Spot& spot : fit ? line.points : std::vector<document::Spot>{})
        corners.push_back({to_lattice(spot.x, resolution()), to_lattice(spot.y, resolution())});
      if (auto clean = clean_polygon(corners)) holes.push_back(std::move(clean->polygon));
    }
    return holes;
  }

  // Calls visit(piece, its attributes) for every piece, placed or not, that is no zone.
  template <class Visit>
  void for_each_piece(const Visit& visit) {
    Marker& marker = file_.marker;
    for (std::size_t k = 0; k < marker.pieces.size(); ++k) {
      if (!marker.pieces[k].rules.zone) visit(marker.pieces[k], file_.attributes.pieces[k]);
    }
    for (std::size_t k = 0; k < marker.unplaced.size(); ++k) visit(marker.unplaced[k], file_.attributes.unplaced[k]);
  }
  [[nodiscard]] static std::string bundle_of(const Json& attributes) {
    const Json* const bundle = attributes.find("bundle");
    return bundle != nullptr && bundle->is_string() ? bundle->get<std::string>() : std::string{};
  }

  // The last rules that name a piece, or its shape, are those that it has.
  void set_rules(const std::vector<RulesOfPieces>& given) {
    using LastOf = std::unordered_map<std::string_view, std::size_t>;  // by id, one more than the number of the rules
    LastOf of_piece, of_shape;
    for_each_piece([&](const Piece& piece, const Json&) {
      of_piece.emplace(piece.id, 0);
      of_shape.emplace(file_.marker.shapes[piece.shape.value].id, 0);
    });
    for (std::size_t k = 0; k < given.size(); ++k) {
      const auto& [piece, shape, rules] = given[k];
      const std::string field = "/pieceRules/" + std::to_string(k);
      const auto beyond = formats::beyond_lattice(rules, resolution());
      if (!fits(!beyond, field + "/rules" + std::string{beyond.value_or("")})) return;
      LastOf& last_of = piece ? of_piece : of_shape;
      const std::string& id = piece ? *piece : *shape;
      const auto found = last_of.find(id);
      if (found == last_of.end()) {
        mistake_.add(ErrorCode::kOutOfRange,
                     json::shortened(Json(id)) +
                         (piece ? " is not a piece of this marker; the id of one of its pieces is allowed"
                                : " is the shape of no piece; the id of a shape that its pieces have is allowed"),
                     field + (piece ? "/piece" : "/shape"));
        return;
      }
      found->second = k + 1;
    }
    for_each_piece([&](Piece& piece, const Json&) {
      const std::size_t last = std::max(of_piece.at(piece.id), of_shape.at(file_.marker.shapes[piece.shape.value].id));
      if (last > 0) piece.rules = formats::rules_on_lattice(given[last - 1].rules, resolution());
    });
  }

  void set_shade(double length) {
    if (!fits(geometry::fits_lattice(length, resolution()), "/shade")) return;
    file_.marker.shade = formats::overlap_on_lattice(length, resolution());
    bool any = false;
    for_each_piece([&](Piece& piece, const Json& attributes) {
      if (piece.rules.shade.empty()) piece.rules.shade = bundle_of(attributes);
      any = any || !piece.rules.shade.empty();
    });
    if (!any) file_.notes.push_back({"/shade", "no piece has a shade or a bundle: the length has no effect"});
  }

  void set_nap(ClothNap nap) {
    std::unordered_map<std::string, std::size_t> bundles;  // numbered in the order in which they come
    std::size_t turned = 0;
    for_each_piece([&](Piece& piece, const Json& attributes) {
      piece.rules.nap = nap == ClothNap::kDown ? marker::Nap::kDown : marker::Nap::kUp;
      if (nap == ClothNap::kUpAndDown) {
        const std::string bundle = bundle_of(attributes);
        const std::size_t number = bundle.empty() ? 0 : bundles.emplace(bundle, bundles.size()).first->second;
        if (number % 2 == 1) piece.rules.nap = marker::Nap::kDown;
      }
      turned += turn_with_nap(piece) ? 1 : 0;
    });
    if (nap == ClothNap::kUpAndDown && bundles.empty())
      mistake_.add(ErrorCode::kOutOfRange, "no piece has a bundle; up and down are allowed", "/napDirection");
    if (turned > 0) {
      file_.notes.push_back(
          {"/napDirection",
           std::to_string(turned) + (turned == 1 ? " piece was" : " pieces were") +
               " turned to lie with the nap; pieces that they overlap now have to be separated from them"});
    }
  }
  // Rotates the piece about the middle of its box if it lies against its nap and its shape allows the other direction.
  // Locks say what may not change, and a group keeps its form: make_marker refuses such pieces where they lie against
  // the nap.
  bool turn_with_nap(Piece& piece) const {
    const Shape& shape = file_.marker.shapes[piece.shape.value];
    if (keeps_nap(piece.rules, piece.orientation) || piece.locked != Locks{} || !piece.group.empty()) return false;
    constexpr double kHalf = 180, kSlack = 1e-9;
    Orientation turned = piece.orientation;
    turned.rotation = Angle::of_degrees(std::remainder(turned.rotation.degrees + kHalf, 2 * kHalf));
    if (!shape.rotations.empty()) {
      const auto allowed = formats::matching_rotation(turned.rotation.degrees, shape.rotations, kSlack);
      if (!allowed) return false;
      turned.rotation = *allowed;
    }
    piece.at =
        piece.at + box_of(oriented(shape.outline, piece.orientation)).low - box_of(oriented(shape.outline, turned)).low;
    piece.orientation = turned;
    return true;
  }

  // Their ids are "zone 1" and the next such ids that neither a piece nor a shape has.
  void add_zones(const std::vector<ClothZone>& zones) {
    std::unordered_set<std::string> used;
    for (const Shape& shape : file_.marker.shapes) used.insert(shape.id);
    for (const auto* pieces : {&file_.marker.pieces, &file_.marker.unplaced}) {
      for (const Piece& piece : *pieces) used.insert(piece.id);
    }
    std::size_t number = 0;
    for (std::size_t k = 0; k < zones.size() && !mistake_; ++k) {
      std::string id;
      do {
        id = "zone " + std::to_string(++number);
      } while (used.contains(id));
      add_zone(zones[k], id, "/zones/" + std::to_string(k));
    }
  }
  void add_zone(const ClothZone& zone, const std::string& id, const std::string& field) {
    const Vec low = corner(zone.from, field + "/from"), high = corner(zone.to, field + "/to");
    if (mistake_) return;
    if (low.x >= high.x || low.y >= high.y) {
      mistake_.add(ErrorCode::kOutOfRange, "to must lie to the right of from and above it", field + "/to");
      return;
    }
    const Vec size = high - low;
    Marker& marker = file_.marker;
    marker.pieces.push_back({.id = id,
                             .shape = {static_cast<std::uint32_t>(marker.shapes.size())},
                             .orientation = {},
                             .at = low,
                             .locked = true,
                             .rules = {.zone = true, .quality = zone.quality}});
    marker.shapes.push_back({.id = id, .outline = {{0, 0}, {size.x, 0}, size, {0, size.y}}, .tilt_limit = {}});
    file_.attributes.pieces.push_back(Json::object());
    file_.attributes.shapes.push_back(Json::object());
  }
  Vec corner(const formats::Decimal& at, const std::string& field) {
    const bool valid = geometry::fits_lattice(at.x, resolution()) && geometry::fits_lattice(at.y, resolution());
    return fits(valid, field) ? Vec{to_lattice(at.x, resolution()), to_lattice(at.y, resolution())} : Vec{};
  }

  MarkerFile file_;
  std::vector<bool> of_zone_;  // the shapes of the zones that the file came with
  json::Mistake mistake_;
};

}  // namespace

Result<MarkerFile> with_cloth(MarkerFile file, const Cloth& cloth) {
  return ClothMaker{std::move(file)}.run(cloth);
}

}  // namespace selvage::protocol::edits
