// The JSON Schema of marker documents, protocol/marker.schema.json, as schemas of the description.  The marker itself
// becomes MarkerDocument, its definitions become PieceDocument, ShapeDocument and so on, and definitions that are not
// objects keep their names: Id, Point, Outline.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "protocol/json/json_text.h"

namespace selvage::protocol::describe {

// Returns the schemas with their names, that of the marker first.  References point to "#/components/schemas/".
[[nodiscard]] std::vector<std::pair<std::string, Json>> marker_schemas();

}  // namespace selvage::protocol::describe
