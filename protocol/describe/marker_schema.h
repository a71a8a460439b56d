// The JSON Schema of marker documents, protocol/marker.schema.json, as schemas of the description: the marker itself is
// MarkerDocument, its definitions are PieceDocument, ShapeDocument and so on, and definitions that are no objects keep
// their names: Id, Point, Outline.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "protocol/json/json_text.h"

namespace selvage::protocol::describe {

// By name, the marker first; references lead to "#/components/schemas/".
[[nodiscard]] std::vector<std::pair<std::string, Json>> marker_schemas();

}  // namespace selvage::protocol::describe
