#include "protocol/trade/aama/blocks/pattern_block.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "protocol/trade/dxf/strokes/curves.h"
#include "protocol/trade/dxf/strokes/fitted_spline.h"
#include "protocol/trade/dxf/text_lines.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::aama::blocks {
namespace {

using document::LineKind;
using document::NotchKind;
using dxf::Entity;

constexpr std::array<std::string_view, 21> kKeys{
    "PIECE NAME",    "SIZE",     "SIZE NAME", "SAMPLE SIZE", "QUANTITY", "ANNOTATION", "CATEGORY",
    "MATERIAL",      "ROTATION", "FLIP",      "TILT",        "FOLD",     "STYLE NAME", "CREATION DATE",
    "CREATION TIME", "AUTHOR",   "PRODUCT",   "VERSION",     "UNITS",    "TOLERANCE",  "GRADE RULE TABLE"};

std::optional<LineKind> line_kind(int layer) {
  switch (layer) {
    case 8: return LineKind::kInternal;
    case 9: return LineKind::kStripe;
    case 10: return LineKind::kPlaid;
    case 11: return LineKind::kCutOut;
    case 12: return LineKind::kInstruction;
    case 14: return LineKind::kSew;
    default: return std::nullopt;
  }
}

std::optional<NotchKind> notch_kind(int layer, double width) {
  switch (layer) {
    case 4: return width > 0 ? NotchKind::kV : NotchKind::kSlit;
    case 80: return NotchKind::kT;
    case 81: return NotchKind::kCastle;
    case 82: return NotchKind::kCheck;
    case 83: return NotchKind::kU;
    default: return std::nullopt;
  }
}

class BlockReader {
 public:
  BlockReader(PatternBlock& block, BlockReading& reading) : block_{block}, reading_{reading} {}

  void read_all(const std::vector<Entity>& entities) {
    std::vector<const Entity*> inserts;
    for (const Entity& entity : entities) {
      if (entity.type == "INSERT" && reading_.blocks)
        inserts.push_back(&entity);
      else
        read(entity);
    }
    for (const Entity* insert : inserts) read_inserted(*insert);
  }

 private:
  void read_inserted(const Entity& insert) {
    if (!reading_.blocks->of(insert)) {
      reading_.notes.push_back(
          note_at(insert.line, "INSERT of block " + json::shortened(Json(decoded(insert.text(2), reading_.encoding))) +
                                   ", which is not in the file"));
      return;
    }
    const dxf::strokes::Insertion outer = at_;
    const std::string_view outer_layer = inherited_;
    const Entity* const outer_insert = insert_;
    const dxf::strokes::Insertion seen =
        dxf::strokes::from_behind(insert) ? outer.after(dxf::strokes::kSeenFromBehind) : outer;
    reading_.blocks->insert(insert, seen, depth_,
                            [&](const dxf::Block& block, const dxf::strokes::Insertion& insertion) {
                              at_ = insertion;
                              insert_ = &insert;
                              inherited_ = dxf::strokes::layer_of(insert, outer_layer);
                              ++depth_;
                              read_all(block.entities);
                              --depth_;
                            });
    at_ = outer;
    inherited_ = outer_layer;
    insert_ = outer_insert;
  }

  // Whether this much more of what inserted entities contain may still be read.
  bool take(std::size_t much) { return !insert_ || reading_.blocks->take(much, *insert_, depth_ - 1); }

  void read(const Entity& entity) {
    const dxf::strokes::Insertion outer = at_;
    if (dxf::strokes::from_behind(entity)) at_ = outer.after(dxf::strokes::kSeenFromBehind);
    const auto layer = whole_number_in(dxf::strokes::layer_of(entity, inherited_));
    if (entity.type == "TEXT" || entity.type == "MTEXT" || entity.type == "ATTDEF")
      read_text(entity);
    else if (!layer || !read_drawn(entity, *layer))
      pass_over(entity);
    at_ = outer;
  }

  [[nodiscard]] Spot spot_of(const dxf::DxfVertex& vertex) const { return at_.apply({vertex.x, vertex.y}); }

  std::optional<Run> run_of(const Entity& entity) {
    const Flattening::Enlarged enlarged{reading_.flattening, at_.scale()};
    auto run = dxf::strokes::run_of(entity, reading_.flattening);
    if (!run || !take(run->points.size())) return std::nullopt;
    if (dxf::strokes::is_fitted(entity))
      reading_.notes.push_back(note_at(entity.line, std::string{dxf::strokes::kFittedNote}));
    at_.apply(*run);
    return run;
  }

  // Whether the entity was used, or is known to be irrelevant.
  bool read_drawn(const Entity& entity, int layer) {
    constexpr int kTurnPoints = 2, kCurvePoints = 3, kDrill = 13, kNotes = 15, kFirstCopy = 84, kLastCopy = 87;
    const bool point = entity.type == "POINT";
    if (layer == kTurnPoints || layer == kCurvePoints) return true;
    if (layer >= kFirstCopy && layer <= kLastCopy) return true;  // copies of 1, 8, 11 and 14 for validation
    if (layer == 1) {
      auto run = run_of(entity);
      if (!run) return point;
      block_.boundary.push_back(*std::move(run));
      return true;
    }
    if (notch_kind(layer, 0)) return read_notch(entity, layer);
    if (layer == kDrill && (point || entity.type == "CIRCLE") && !entity.vertices.empty()) {
      block_.annotations.drills.push_back(spot_of(entity.vertices.front()));
      return true;
    }
    if (layer >= 5 && layer <= 7) return read_reference(entity, layer);
    const auto kind = line_kind(layer == kNotes ? 8 : layer);
    if (point || !kind) return point;
    auto run = run_of(entity);
    if (!run || run->points.size() < 2) return false;
    block_.annotations.lines.push_back({*kind, run->closed, std::move(run->points)});
    return true;
  }

  // A POINT with depth, width and angle; or a LINE, whose length is the depth.
  bool read_notch(const Entity& entity, int layer) {
    if (entity.vertices.empty()) return false;
    document::Notch notch;
    notch.at = spot_of(entity.vertices.front());
    if (entity.type == "POINT") {
      const auto elevation = entity.number(38);
      notch.depth = std::abs(entity.number(30).value_or(elevation.value_or(0))) * at_.scale();
      notch.width = std::abs(entity.number(39).value_or(0)) * at_.scale();
      if (const auto angle = entity.number(50)) notch.angle = at_.apply_to_angle(*angle);
    } else if (entity.type == "LINE" && entity.vertices.size() > 1) {
      const Spot end = spot_of(entity.vertices.back());
      notch.depth = distance(notch.at, end);
      notch.angle = std::atan2(end.y - notch.at.y, end.x - notch.at.x) * 180 / std::numbers::pi;
    } else {
      return false;
    }
    notch.kind = *notch_kind(layer, notch.width);
    block_.annotations.notches.push_back(notch);
    return true;
  }

  // Layers 5, 6 and 7: the reference for grading, the mirror line and the grain.
  bool read_reference(const Entity& entity, int layer) {
    if (entity.type == "POINT") return true;
    if (entity.vertices.size() < 2) return false;
    const std::pair<Spot, Spot> line{spot_of(entity.vertices.front()), spot_of(entity.vertices.back())};
    if (line.first == line.second) return false;
    (layer == 5 ? block_.grade_references : layer == 6 ? block_.mirror_lines : block_.grains).push_back(line);
    return true;
  }

  void read_text(const Entity& entity) {
    if (entity.vertices.empty()) return;
    const double height = entity.number(40).value_or(0);
    constexpr std::size_t kBytesOfAPoint = 16;
    double offset = 0;
    for (const std::string& text : dxf::text_lines(entity, reading_.encoding)) {
      if (!take(text.size() / kBytesOfAPoint)) return;
      read_line(text, at_.apply({entity.vertices.front().x, entity.vertices.front().y + offset}), entity);
      offset -= 1.5 * height;
    }
  }

  void read_line(const std::string& text, Spot at, const Entity& entity) {
    if (text.front() == '#') {
      const auto rule = whole_number_in(trimmed(std::string_view{text}.substr(1)));
      if (rule) block_.graded_points.push_back({*rule, at, entity.line});
      return;
    }
    if (in_capitals(text) == "NM") {
      block_.unmirrored_spots.push_back(at);
      return;
    }
    if (auto pair = key_and_value(text)) {
      const auto [place, fresh] = block_.texts.emplace(pair->first, pair->second);
      if (!fresh && place->second != pair->second) {
        reading_.notes.push_back(note_at(entity.line, pair->first + " is given again, as " +
                                                          json::shortened(Json(pair->second)) + "; the first counts"));
      }
      return;
    }
    block_.annotations.texts.push_back(
        {text, at, entity.number(40).value_or(0) * at_.scale(), at_.apply_to_angle(entity.number(50).value_or(0))});
  }

  void pass_over(const Entity& entity) {
    const std::string what = std::string{entity.type} + " on layer " + printable(entity.layer);
    reading_.passed_over.emplace(what, entity.line);
  }

  PatternBlock& block_;
  BlockReading& reading_;
  dxf::strokes::Insertion at_{};  // what the blocks around an entity do
  std::string_view inherited_;    // the layer of their INSERT; empty outside of them
  const Entity* insert_{};        // the innermost one; null outside of them
  int depth_{};
};

}  // namespace

const std::string* PatternBlock::text(const std::string& key) const {
  const auto found = texts.find(key);
  return found == texts.end() || found->second.empty() ? nullptr : &found->second;
}

PatternBlock read_pattern_block(const dxf::Block& block, BlockReading& reading) {
  PatternBlock read;
  read.name = decoded(block.name, reading.encoding);
  read.line = block.line;
  BlockReader reader{read, reading};
  reader.read_all(block.entities);
  for (const document::DrawnLine& line : read.annotations.lines) {
    const auto starts_here = [&](const Spot& spot) { return spot == line.points.front(); };
    read.mirrored.push_back(std::none_of(read.unmirrored_spots.begin(), read.unmirrored_spots.end(), starts_here));
  }
  return read;
}

bool enlarge_shallow_notches(std::vector<PatternBlock>& blocks) {
  double deepest = 0;
  for (const PatternBlock& block : blocks) {
    for (const document::Notch& notch : block.annotations.notches) deepest = std::max(deepest, notch.depth);
  }
  if (deepest <= 0 || deepest >= 1) return false;
  for (PatternBlock& block : blocks) {
    for (document::Notch& notch : block.annotations.notches) {
      notch.depth *= 10;
      notch.width *= 10;
    }
  }
  return true;
}

std::optional<std::pair<std::string, std::string>> key_and_value(std::string_view text) {
  const std::size_t colon = std::min(text.find(':'), text.find('='));
  if (colon == std::string_view::npos) return std::nullopt;
  std::string key = in_capitals(trimmed(text.substr(0, colon)));
  if (key == "UNIT") key = "UNITS";
  if (key == "QTY" || key == "QTY.") key = "QUANTITY";
  if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end()) return std::nullopt;
  return std::pair{std::move(key), std::string{trimmed(text.substr(colon + 1))}};
}

}  // namespace selvage::protocol::trade::aama::blocks
