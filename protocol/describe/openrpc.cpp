#include "protocol/describe/openrpc.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "protocol/describe/call_errors.h"
#include "protocol/describe/marker_schema.h"
#include "protocol/methods/method_table.h"

namespace selvage::protocol::describe {
namespace {

using schema::FieldDescription;
using Kind = schema::Type::Kind;

// The named types that a document refers to, by name.
class Components {
 public:
  void add_all(const std::vector<FieldDescription>& fields) {
    for (const FieldDescription& field : fields) add(field.type);
  }
  [[nodiscard]] const std::map<std::string_view, const schema::Component*>& all() const { return all_; }

 private:
  void add(const schema::Type& type) {
    for (const schema::Type& part : type.parts) add(part);
    if (type.kind != Kind::kNamed) return;
    const schema::Component& component = type.component();
    if (!all_.emplace(component.name, &component).second) return;
    add_all(component.fields);
    if (component.same_as) add(*component.same_as);
  }

  std::map<std::string_view, const schema::Component*> all_;
};

Json reference_to(std::string_view component) {
  return {{"$ref", "#/components/schemas/" + std::string{component}}};
}

Json either_schema(const schema::Type& type) {
  Json alternatives = Json::array();
  for (const schema::Type& part : type.parts) {
    // Nested alternatives become one list.
    Json inner = type_schema(part);
    for (Json& each : inner.contains("anyOf") ? inner["anyOf"] : Json::array({inner}))
      alternatives.push_back(std::move(each));
  }
  return {{"anyOf", std::move(alternatives)}};
}

// The schema of a field with its limits and its default value.
Json field_schema(const FieldDescription& field) {
  Json schema = type_schema(field.type);
  // Other members of an object with a reference would be ignored.
  if (schema.contains("$ref")) schema = Json{{"allOf", Json::array({std::move(schema)})}};
  const schema::Limits& limits = field.limits;
  if (limits.range) {
    schema["minimum"] = limits.range->least;
    schema["maximum"] = limits.range->most;
  }
  if (limits.bytes) {
    schema["minLength"] = limits.bytes->least;
    schema["maxLength"] = limits.bytes->most;
  }
  if (limits.entries) {
    schema["minItems"] = limits.entries->least;
    schema["maxItems"] = limits.entries->most;
  }
  if (!field.fallback.is_null()) schema["default"] = field.fallback;
  return schema;
}

// The meaning of a field.  JSON Schema counts characters, so its maxLength alone promises more than is allowed.
std::string description_of(const FieldDescription& field) {
  return std::string{field.meaning} + (field.limits.bytes ? " Its length is counted in bytes of UTF-8." : "");
}

Json object_schema(const std::vector<FieldDescription>& fields) {
  Json properties = Json::object();
  Json required = Json::array();
  for (const FieldDescription& field : fields) {
    Json schema = field_schema(field);
    schema["description"] = description_of(field);
    properties[std::string{field.name}] = std::move(schema);
    if (field.required) required.push_back(field.name);
  }
  return {{"type", "object"}, {"properties", std::move(properties)}, {"required", std::move(required)}};
}

Json component_schema(const schema::Component& component) {
  Json schema;
  if (!component.words.empty()) {
    Json words = Json::array();
    for (const std::string_view word : component.words) words.push_back(word);
    schema = {{"type", "string"}, {"enum", std::move(words)}};
  } else if (component.same_as) {
    schema = type_schema(*component.same_as);
  } else {
    schema = object_schema(component.fields);
  }
  schema["description"] = component.meaning;
  return schema;
}

Json params_json(const std::vector<FieldDescription>& params) {
  Json list = Json::array();
  for (const bool required : {true, false}) {  // OpenRPC wants the required ones first
    for (const FieldDescription& param : params) {
      if (param.required != required) continue;
      list.push_back({{"name", param.name},
                      {"description", description_of(param)},
                      {"required", param.required},
                      {"schema", field_schema(param)}});
    }
  }
  return list;
}

// References to the errors in the catalogue that the method may return.
Json errors_json(const calls::Method& method, const std::vector<FieldDescription>& params) {
  Json list = Json::array();
  const auto has = [&params](std::string_view name) {
    return std::any_of(params.begin(), params.end(), [&](const FieldDescription& param) { return param.name == name; });
  };
  for (const CallError& error : call_errors()) {
    const bool possible = error.when == CallError::When::kAny ||
                          (error.when == CallError::When::kWithMarker && has("markerId")) ||
                          (error.when == CallError::When::kWithBaseRevision && has("baseRev")) ||
                          (error.when == CallError::When::kMotion && (method.motion || has("deadlineMs"))) ||
                          std::find(error.also.begin(), error.also.end(), method.name) != error.also.end();
    if (possible) list.push_back({{"$ref", "#/components/errors/" + std::string{error.name}}});
  }
  return list;
}

Json error_components() {
  Json errors = Json::object();
  for (const CallError& error : call_errors()) {
    errors[std::string{error.name}] = {{"code", static_cast<int>(error.code)}, {"message", error.meaning}};
  }
  return errors;
}

}  // namespace

Json type_schema(const schema::Type& type) {
  switch (type.kind) {
    case Kind::kString: return {{"type", "string"}};
    case Kind::kInteger: return {{"type", "integer"}};
    case Kind::kNumber: return {{"type", "number"}};
    case Kind::kBoolean: return {{"type", "boolean"}};
    case Kind::kNull: return {{"type", "null"}};
    case Kind::kObject: return type.text.empty() ? Json{{"type", "object"}} : reference_to(type.text);
    case Kind::kConstant: return {{"const", type.text}};
    case Kind::kNamed: return reference_to(type.component().name);
    case Kind::kList: return {{"type", "array"}, {"items", type_schema(type.parts[0])}};
    case Kind::kPair:
      return {{"type", "array"}, {"items", type_schema(type.parts[0])}, {"minItems", 2}, {"maxItems", 2}};
    case Kind::kEither: return either_schema(type);
  }
  return {};
}

Json openrpc_document(std::string_view version) {
  Components components;
  Json methods = Json::array();
  for (const calls::Method& method : methods::method_table().all()) {
    const auto params = method.params();
    const auto results = method.results();
    components.add_all(params);
    components.add_all(results);
    methods.push_back({{"name", method.name},
                       {"summary", method.summary},
                       {"paramStructure", "by-name"},
                       {"params", params_json(params)},
                       {"result", {{"name", "result"}, {"schema", object_schema(results)}}},
                       {"errors", errors_json(method, params)}});
  }
  Json notifications = Json::array();
  for (const methods::Notification& notification : methods::notifications()) {
    components.add_all(notification.params());
    notifications.push_back({{"name", notification.name},
                             {"summary", notification.summary},
                             {"params", params_json(notification.params())}});
  }
  Json schemas = Json::object();
  for (const auto& [name, component] : components.all()) schemas[std::string{name}] = component_schema(*component);
  // Ids and points are the same in documents as in messages.
  for (auto& [name, schema] : marker_schemas()) {
    if (!schemas.contains(name)) schemas.append(name, std::move(schema));
  }
  return {{"openrpc", "1.2.6"},
          {"info", {{"title", "Selvage"}, {"version", version}}},
          {"methods", std::move(methods)},
          {"components", {{"schemas", std::move(schemas)}, {"errors", error_components()}}},
          {"x-notifications", std::move(notifications)}};
}

}  // namespace selvage::protocol::describe
