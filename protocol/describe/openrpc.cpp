#include "protocol/describe/openrpc.h"

#include <array>
#include <string>

#include "protocol/describe/daemon_methods.h"
#include "protocol/describe/schemas.h"

namespace selvage::protocol::describe {
namespace {

constexpr std::array kOnMarkerParams{calls::Word{"markerId", "string", calls::kRequired, "The marker's id."}};
constexpr std::array kOnMarkerResults{calls::Word{"markerId", "string", calls::kRequired, "The marker's id."},
                                      calls::Word{"revision", "integer", calls::kRequired, "The marker's revision."}};
constexpr std::array kMotionParams{
    calls::Word{"baseRev", "integer", calls::kOptional, "Refuse when the marker is at another revision."},
    calls::Word{"commit", "boolean", calls::kOptional, "False: answer, but leave the marker as it is."},
    calls::Word{"opId", "string", calls::kOptional, "A name for this call: a retry of it gets the same answer."},
    calls::Word{"deadlineMs", "number", calls::kOptional, "Then the best so far is answered; 1 to 86,400,000."},
    calls::Word{"progressToken", "ProgressToken", calls::kOptional, "Rounds are told under it."},
    calls::Word{"timing", "boolean", calls::kOptional, "Answer with ms and cache, too."}};
constexpr std::array kStudyParams{calls::Word{"deadlineMs", "number", calls::kOptional,
                                              "Then the call is refused if it has no answer; 1 to 86,400,000."}};
constexpr std::array kMotionResults{
    calls::Word{"name", "string", calls::kRequired, "The marker's."},
    calls::Word{"pieces", "integer", calls::kRequired, "How many there are."},
    calls::Word{"lengthBefore", "number", calls::kRequired, "Exact."},
    calls::Word{"lengthAfter", "number", calls::kRequired, "Exact."},
    calls::Word{"utilisationBefore", "number", calls::kRequired, "0 to 1."},
    calls::Word{"utilisationAfter", "number", calls::kRequired, "0 to 1."},
    calls::Word{"valid", "boolean", calls::kRequired, "Of the result, proved anew."},
    calls::Word{"healed", "Healing", calls::kRequired, "Small overlaps that were parted first."},
    calls::Word{"placements", "Placement[]", calls::kRequired, "Of the pieces that moved."},
    calls::Word{"ms", "StageTimes", calls::kOptional, "With timing."},
    calls::Word{"cache", "CacheCounts", calls::kOptional, "With timing."}};

void append(std::vector<calls::Word>& all, std::span<const calls::Word> more) {
  all.insert(all.end(), more.begin(), more.end());
}

bool is_primitive(std::string_view type) {
  constexpr std::array<std::string_view, 6> kPrimitives{"string", "integer", "number", "boolean", "object", "null"};
  return std::find(kPrimitives.begin(), kPrimitives.end(), type) != kPrimitives.end();
}

Json object_schema(std::span<const calls::Word> fields) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const calls::Word& field : fields) {
    Json schema = type_schema(field.type);
    // Beside a reference other words would not be read.
    if (schema.contains("$ref")) schema = Json{{"allOf", Json::array({std::move(schema)})}};
    schema["description"] = field.meaning;
    properties[std::string{field.name}] = std::move(schema);
    if (field.required) required.push_back(field.name);
  }
  return {{"type", "object"}, {"properties", std::move(properties)}, {"required", std::move(required)}};
}

Json schemas() {
  Json all = Json::object();
  const auto add = [&all](std::string_view name, std::string_view meaning, Json schema) {
    schema["description"] = meaning;
    all[std::string{name}] = std::move(schema);
  };
  for (const ChoiceType& choice : choice_types()) {
    add(choice.name, choice.meaning, {{"type", "string"}, {"enum", choice.words}});
  }
  for (const NamedType& named : named_types()) add(named.name, named.meaning, type_schema(named.type));
  for (const ObjectType& object : object_types()) add(object.name, object.meaning, object_schema(object.fields));
  return all;
}

Json params_json(std::span<const calls::Word> params) {
  Json list = Json::array();
  for (const bool required : {true, false}) {  // OpenRPC wants the required ones first
    for (const calls::Word& word : params) {
      if (word.required != required) continue;
      list.push_back({{"name", word.name},
                      {"description", word.meaning},
                      {"required", word.required},
                      {"schema", type_schema(word.type)}});
    }
  }
  return list;
}

Json method_json(const ToldMethod& method) {
  return {{"name", method.name},
          {"summary", method.summary},
          {"paramStructure", "by-name"},
          {"params", params_json(method.params)},
          {"result", {{"name", "result"}, {"schema", object_schema(method.results)}}}};
}

}  // namespace

ToldMethod told(const calls::MarkerMethod& method) {
  ToldMethod all{method.name, method.words.summary, {}, {}};
  append(all.params, kOnMarkerParams);
  append(all.params, method.words.params);
  append(all.results, kOnMarkerResults);
  append(all.results, method.words.results);
  if (method.motion()) {
    append(all.params, kMotionParams);
    append(all.results, kMotionResults);
  }
  if (method.kind == calls::MethodKind::kStudy) append(all.params, kStudyParams);
  return all;
}

ToldMethod told(std::string_view name, const calls::MethodWords& words) {
  ToldMethod all{name, words.summary, {}, {}};
  append(all.params, words.params);
  append(all.results, words.results);
  return all;
}

Json type_schema(std::string_view type) {
  if (const std::size_t bar = type.find('|'); bar != std::string_view::npos) {
    Json either = Json::array({type_schema(type.substr(0, bar))});
    Json rest = type_schema(type.substr(bar + 1));
    for (const Json& other : rest.contains("anyOf") ? rest["anyOf"] : Json::array({rest})) either.push_back(other);
    return {{"anyOf", std::move(either)}};
  }
  if (type.ends_with("[2]")) {
    return {
        {"type", "array"}, {"items", type_schema(type.substr(0, type.size() - 3))}, {"minItems", 2}, {"maxItems", 2}};
  }
  if (type.ends_with("[]")) return {{"type", "array"}, {"items", type_schema(type.substr(0, type.size() - 2))}};
  if (type.starts_with('\'')) return {{"const", type.substr(1, type.size() - 2)}};
  if (is_primitive(type)) return {{"type", type}};
  return {{"$ref", "#/components/schemas/" + std::string{type}}};
}

Json openrpc_document(std::string_view version, std::span<const ToldMethod> methods) {
  Json list = Json::array();
  for (const ToldMethod& method : methods) list.push_back(method_json(method));
  Json notifications = Json::array();
  for (const NamedWords& notification : notification_words()) {
    notifications.push_back({{"name", notification.name},
                             {"summary", notification.words.summary},
                             {"params", params_json(notification.words.params)}});
  }
  return {{"openrpc", "1.2.6"},
          {"info", {{"title", "Selvage"}, {"version", version}}},
          {"methods", std::move(list)},
          {"components", {{"schemas", schemas()}}},
          {"x-notifications", std::move(notifications)}};
}

}  // namespace selvage::protocol::describe
