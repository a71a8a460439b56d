#include "server/store/summary.h"

#include "protocol/json/fields.h"
#include "protocol/json/json_text.h"

namespace selvage::server::store {

Summary summary_of(const Marker& marker) {
  Summary summary{.name = marker.name,
                  .pieces = piece_count(marker),
                  .unplaced = marker.unplaced.size(),
                  .length = to_decimal(length_of(marker), marker.resolution),
                  .utilisation = utilisation_of(marker)};
  for (const Piece& piece : marker.pieces) summary.vertices += marker.shapes[piece.shape.value].outline.size();
  return summary;
}

std::string summary_text(const Summary& summary) {
  Json json{{"name", summary.name},         {"pieces", summary.pieces}, {"unplaced", summary.unplaced},
            {"vertices", summary.vertices}, {"length", summary.length}, {"utilisation", summary.utilisation}};
  if (summary.of_connection) json["ofConnection"] = true;
  return protocol::json::to_text(json);
}

std::optional<Summary> read_summary(const std::string& text) {
  const auto json = protocol::json::parse(text);
  if (!json) return std::nullopt;
  protocol::json::Mistake mistake;
  protocol::json::Fields fields{*json, "", mistake};
  const auto count = [&fields](std::string_view key) {
    return static_cast<std::size_t>(fields.number(key, {.least = 0, .most = 1e12}));
  };
  Summary summary;
  summary.name = fields.text("name");
  summary.pieces = count("pieces");
  summary.unplaced = count("unplaced");
  summary.vertices = count("vertices");
  summary.length = fields.number("length");
  summary.utilisation = fields.number("utilisation");
  summary.of_connection = fields.flag_or("ofConnection", false);
  fields.finish();
  if (mistake) return std::nullopt;
  return summary;
}

}  // namespace selvage::server::store
