#include "protocol/trade/dxf/drawing.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "protocol/trade/style.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {
namespace {

constexpr int kClosedFlag = 1;
constexpr int kControlFlag = 16;  // of a VERTEX: it controls a spline through vertices that follow

double coordinate(const Tag& tag, json::Mistake& mistake) {
  const auto value = number_in(tag.text);
  if (value && std::abs(*value) <= kFarthestCoordinate) return *value;
  if (value) {
    mistake.add(error_at(tag.line, ErrorCode::kOutOfRange,
                         json::number_text(*value) + " is too far out; 1e8 in either direction is allowed"));
    return 0;
  }
  mistake.add(ErrorCode::kSyntax,
              "line " + std::to_string(tag.line) + ": " + json::shortened(Json(printable(tag.text))) +
                  " where a number is required",
              line_field(tag.line));
  return 0;
}

// The vertices among the tags: each begins with its x coordinate, whose code is `x`.
void read_vertices(Entity& entity, int x, json::Mistake& mistake) {
  constexpr int kToY = 10, kBulge = 42;
  for (const Tag& tag : entity.tags) {
    if (tag.code == x) {
      entity.vertices.push_back({coordinate(tag, mistake), 0, 0});
    } else if (!entity.vertices.empty() && tag.code == x + kToY) {
      entity.vertices.back().y = coordinate(tag, mistake);
    } else if (!entity.vertices.empty() && tag.code == kBulge && entity.type != "INSERT") {
      entity.vertices.back().bulge = coordinate(tag, mistake);
    }
  }
}

// Reads the tags one entity after another.
class Reader {
 public:
  Reader(std::span<const Tag> tags, json::Mistake& mistake) : tags_{tags}, mistake_{mistake} {}

  DxfDrawing read() {
    while (at_ < tags_.size() && !mistake_) {
      const Entity entity = take();
      if (entity.type == "SECTION") section_ = entity.text(2);
      if (entity.type == "SECTION" && section_ == "HEADER")
        read_header(entity);
      else if (section_ == "TABLES")
        read_layer(entity);
      else if (section_ == "BLOCKS" || section_ == "ENTITIES")
        sort(entity);
    }
    return std::move(drawing_);
  }

 private:
  // The next entity: a tag of code 0, and the tags up to the next of them.
  Entity take() {
    const std::size_t first = at_++;
    while (at_ < tags_.size() && tags_[at_].code != 0) ++at_;
    Entity entity;
    if (tags_[first].code != 0) return entity;  // tags before the first entity
    entity.type = tags_[first].text;
    entity.line = tags_[first].line;
    entity.tags = tags_.subspan(first + 1, at_ - first - 1);
    entity.layer = entity.text(8);
    return entity;
  }

  void read_header(const Entity& header) {
    std::string_view variable;
    for (const Tag& tag : header.tags) {
      if (tag.code == 9)
        variable = tag.text;
      else if (variable == "$INSUNITS" && tag.code == 70)
        drawing_.insert_units = whole_number_in(tag.text);
      else if (variable == "$DWGCODEPAGE" && tag.code == 3)
        drawing_.code_page = tag.text;
      else if (variable == "$ACADVER" && tag.code == 1)
        drawing_.version = tag.text;
    }
  }

  void read_layer(const Entity& layer) {
    constexpr int kFrozen = 1;
    if (layer.type != "LAYER") return;
    const bool frozen = (whole_number_in(layer.text(70)).value_or(0) & kFrozen) != 0;
    const bool off = whole_number_in(layer.text(62)).value_or(0) < 0;  // its colour
    if (frozen || off) drawing_.hidden_layers.insert(layer.text(2));
  }

  void sort(Entity entity) {
    if (entity.type == "BLOCK") {
      drawing_.blocks.push_back(
          {entity.text(2), entity.line, entity.number(10).value_or(0), entity.number(20).value_or(0), {}});
      in_block_ = true;
    } else if (entity.type == "ENDBLK" || entity.type == "ENDSEC" || entity.type == "SECTION") {
      in_block_ = false;
      polyline_ = nullptr;
    } else if (entity.type == "VERTEX") {
      read_vertices(entity, 10, mistake_);
      const bool controls = (whole_number_in(entity.text(70)).value_or(0) & kControlFlag) != 0;
      if (polyline_ && !controls && !entity.vertices.empty()) polyline_->vertices.push_back(entity.vertices.front());
    } else if (entity.type != "SEQEND") {
      keep(std::move(entity));
    } else {
      polyline_ = nullptr;
    }
  }

  void demand_numbers(const Entity& entity, std::initializer_list<int> codes) {
    for (const Tag& tag : entity.tags) {
      const bool demanded = std::find(codes.begin(), codes.end(), tag.code) != codes.end();
      if (demanded && !tag.text.empty()) coordinate(tag, mistake_);
    }
  }

  void keep(Entity entity) {
    if (section_ == "BLOCKS" && !in_block_) return;
    if (whole_number_in(entity.text(67)) == 1) {  // paper space: the frame of a printed page
      polyline_ = nullptr;
      return;
    }
    const bool polyline = entity.type == "POLYLINE";
    if (polyline || entity.type == "LWPOLYLINE") {
      entity.closed = (whole_number_in(entity.text(70)).value_or(0) & kClosedFlag) != 0;
    }
    // A POLYLINE's own point is a dummy.
    if (!polyline) read_vertices(entity, 10, mistake_);
    if (entity.type == "LINE") read_vertices(entity, 11, mistake_);
    if (entity.type == "SPLINE" && entity.vertices.empty()) demand_numbers(entity, {11, 21});  // its fit points
    if (entity.type == "INSERT") demand_numbers(entity, {41, 42, 44, 45, 50});  // how it scales, repeats and turns
    auto& list = section_ == "BLOCKS" ? drawing_.blocks.back().entities : drawing_.entities;
    list.push_back(std::move(entity));
    if (polyline)
      polyline_ = &list.back();
    else if (list.back().type != "ATTRIB")
      polyline_ = nullptr;
  }

  std::span<const Tag> tags_;
  json::Mistake& mistake_;
  std::size_t at_{};
  std::string_view section_;
  bool in_block_{};
  Entity* polyline_{};  // to which VERTEX belongs
  DxfDrawing drawing_;
};

}  // namespace

std::string_view Entity::text(int code) const {
  const auto found = std::find_if(tags.begin(), tags.end(), [code](const Tag& tag) { return tag.code == code; });
  return found == tags.end() ? std::string_view{} : found->text;
}

std::optional<double> Entity::number(int code) const {
  const std::string_view value = text(code);
  const auto read = value.empty() ? std::nullopt : number_in(value);
  return read && std::abs(*read) <= kFarthestCoordinate ? read : std::nullopt;
}

Result<DxfDrawing> read_drawing(std::span<const Tag> tags) {
  json::Mistake mistake;
  DxfDrawing drawing = Reader{tags, mistake}.read();
  if (mistake) return mistake.error();
  return drawing;
}

}  // namespace selvage::protocol::trade::dxf
