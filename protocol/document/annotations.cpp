#include "protocol/document/annotations.h"

#include <algorithm>
#include <cmath>

namespace selvage::protocol::document {
namespace {

// The field, if the value is an object that has it.
const Json* field_of(const Json& value, std::string_view key) {
  return value.is_object() ? value.find(key) : nullptr;
}

std::optional<double> number_of(const Json& value, std::string_view key) {
  const Json* found = field_of(value, key);
  if (!found || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::optional<Spot> spot_from(const Json& value) {
  if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) return std::nullopt;
  return Spot{value[0].get<double>(), value[1].get<double>()};
}

std::optional<Spot> spot_of(const Json& value, std::string_view key) {
  const Json* found = field_of(value, key);
  return found ? spot_from(*found) : std::nullopt;
}

// The position among `words` of the text in the field.
template <class Words>
std::optional<std::size_t> word_of(const Json& value, std::string_view key, const Words& words) {
  const Json* found = field_of(value, key);
  if (!found || !found->is_string()) return std::nullopt;
  const auto at = std::find(words.begin(), words.end(), found->get<std::string>());
  if (at == words.end()) return std::nullopt;
  return static_cast<std::size_t>(at - words.begin());
}

std::optional<Notch> notch_from(const Json& value) {
  const auto kind = word_of(value, "kind", kNotchWords);
  const auto at = spot_of(value, "at");
  if (!kind || !at) return std::nullopt;
  return Notch{static_cast<NotchKind>(*kind), *at, number_of(value, "depth").value_or(0),
               number_of(value, "width").value_or(0), number_of(value, "angle")};
}

std::optional<DrawnLine> line_from(const Json& value) {
  const auto kind = word_of(value, "kind", kLineWords);
  const Json* points = field_of(value, "points");
  if (!kind || !points || !points->is_array()) return std::nullopt;
  DrawnLine line{static_cast<LineKind>(*kind), false, {}};
  for (const Json& point : *points) {
    const auto spot = spot_from(point);
    if (!spot) return std::nullopt;
    line.points.push_back(*spot);
  }
  if (line.points.size() < 2) return std::nullopt;
  const Json* closed = field_of(value, "closed");
  line.closed = closed && closed->is_boolean() && closed->get<bool>();
  return line;
}

std::optional<DrawnText> text_from(const Json& value) {
  const Json* text = field_of(value, "text");
  const auto at = spot_of(value, "at");
  if (!text || !text->is_string() || !at) return std::nullopt;
  return DrawnText{text->get<std::string>(), *at, number_of(value, "height").value_or(0),
                   number_of(value, "angle").value_or(0)};
}

template <class T, class From>
std::vector<T> list_of(const Json& annotations, std::string_view key, From from) {
  std::vector<T> list;
  const Json* values = field_of(annotations, key);
  if (!values || !values->is_array()) return list;
  for (const Json& value : *values) {
    if (auto read = from(value)) list.push_back(*std::move(read));
  }
  return list;
}

Json spot_json(const Spot& spot) {
  return Json::array({spot.x, spot.y});
}

Json notch_json(const Notch& notch) {
  Json json{{"kind", kNotchWords[static_cast<std::size_t>(notch.kind)]}, {"at", spot_json(notch.at)}};
  if (notch.depth > 0) json["depth"] = notch.depth;
  if (notch.width > 0) json["width"] = notch.width;
  if (notch.angle) json["angle"] = *notch.angle;
  return json;
}

Json line_json(const DrawnLine& line) {
  Json points = Json::array();
  for (const Spot& spot : line.points) points.push_back(spot_json(spot));
  Json json{{"kind", kLineWords[static_cast<std::size_t>(line.kind)]}};
  if (line.closed) json["closed"] = true;
  json["points"] = std::move(points);
  return json;
}

Json text_json(const DrawnText& text) {
  Json json{{"text", text.text}, {"at", spot_json(text.at)}};
  if (text.height > 0) json["height"] = text.height;
  if (text.angle != 0) json["angle"] = text.angle;
  return json;
}

template <class T, class Write>
void put_list(Json& json, const char* key, const std::vector<T>& list, Write write) {
  if (list.empty()) return;
  Json values = Json::array();
  for (const T& value : list) values.push_back(write(value));
  json[key] = std::move(values);
}

}  // namespace

Annotations annotations_of(const Json& attributes) {
  const Json* annotations = field_of(attributes, "annotations");
  if (!annotations) return {};
  return {list_of<Notch>(*annotations, "notches", notch_from), list_of<Spot>(*annotations, "drills", spot_from),
          list_of<DrawnLine>(*annotations, "lines", line_from), list_of<DrawnText>(*annotations, "texts", text_from)};
}

Json annotations_json(const Annotations& annotations) {
  Json json = Json::object();
  put_list(json, "notches", annotations.notches, notch_json);
  put_list(json, "drills", annotations.drills, spot_json);
  put_list(json, "lines", annotations.lines, line_json);
  put_list(json, "texts", annotations.texts, text_json);
  return json;
}

}  // namespace selvage::protocol::document
