#include "protocol/describe/marker_schema.h"

#include <cctype>
#include <string_view>

#include "protocol/describe/marker_schema_text.h"

namespace selvage::protocol::describe {
namespace {

// unplaced_piece -> UnplacedPieceDocument, outline -> Outline
std::string component_name(std::string_view definition, const Json& schema) {
  std::string name;
  bool capital = true;
  for (const char letter : definition) {
    if (letter != '_') name += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    capital = letter == '_';
  }
  return schema.contains("properties") ? name + "Document" : name;
}

// The schema, in which references to definitions are replaced by references to components.
Json with_components(const Json& schema, const Json& definitions) {
  constexpr std::string_view kBefore = "#/definitions/";
  if (schema.is_array()) {
    Json list = Json::array();
    for (const Json& element : schema) list.push_back(with_components(element, definitions));
    return list;
  }
  if (!schema.is_object()) return schema;
  Json fields = Json::object();
  for (const auto& [name, value] : schema.items()) {
    if (name == "$ref") {
      const std::string_view definition = std::string_view{value.text()}.substr(kBefore.size());
      fields[name] = "#/components/schemas/" + component_name(definition, definitions[definition]);
    } else {
      fields[name] = with_components(value, definitions);
    }
  }
  return fields;
}

}  // namespace

std::vector<std::pair<std::string, Json>> marker_schemas() {
  Json marker = Json::parse(kMarkerSchemaText);
  const Json definitions = marker["definitions"];
  for (const char* field : {"$schema", "title", "definitions"}) marker.erase(field);
  std::vector<std::pair<std::string, Json>> schemas;
  schemas.emplace_back(component_name("marker", marker), with_components(marker, definitions));
  for (const auto& [name, schema] : definitions.items()) {
    schemas.emplace_back(component_name(name, schema), with_components(schema, definitions));
  }
  return schemas;
}

}  // namespace selvage::protocol::describe
