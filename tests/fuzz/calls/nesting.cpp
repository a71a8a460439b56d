// Fuzz target: the first byte chooses marker.nest or marker.nestSheets, the rest is the text of its parameters.  The
// marker has a placed, a locked (for marker.nest) and several unplaced pieces, of which one may have any rotation.
//
// Every marker in an answer must be valid, and every piece must be in it once, placed or left over.
#include <algorithm>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "protocol/calls/method.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/method_table.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

constexpr int kMoves = 30;

MarkerFile file_with(bool locked) {
  const std::string lock = locked ? "true" : "false";
  return *protocol::formats::read_marker(R"({
    "format": "selvage-marker", "version": 1, "strip": {"width": 60, "longest": 90}, "spacing": 1,
    "shapes": [
      {"id": "u", "outline": [[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [30, 20], [30, 30], [0, 30]],
       "rotations": [0, 90, 180]},
      {"id": "wedge", "outline": [[0, 0], [20, 0], [0, 10]], "rotations": [0, 180], "flip": true, "tilt_limit": 2},
      {"id": "kite", "outline": [[0, 0], [10, -5], [25, 0], [10, 5]], "rotations": "any"}],
    "pieces": [{"id": "a", "shape": "u", "at": [0, 0]}, {"id": "b", "shape": "u", "at": [50, 5], "locked": )" +
                                         lock + R"(}],
    "unplaced": [{"id": "c", "shape": "wedge"}, {"id": "d", "shape": "wedge"}, {"id": "e", "shape": "kite"}]})");
}

void judge_ids(std::vector<std::string> ids) {
  std::sort(ids.begin(), ids.end());
  demand(ids == std::vector<std::string>{"a", "b", "c", "d", "e"}, "a piece is missing, or is there twice");
}

void judge_nest(const protocol::calls::MethodAnswer& answer) {
  demand(answer.fields["valid"] == true, "an answer is not valid");
  if (!answer.next) return;
  demand(is_valid(*answer.next), "the next marker is not valid");
  std::vector<std::string> ids;
  for (const Piece& piece : answer.next->pieces) ids.push_back(piece.id);
  for (const Piece& piece : answer.next->unplaced) ids.push_back(piece.id);
  judge_ids(std::move(ids));
}

void judge_sheets(const protocol::calls::MethodAnswer& answer) {
  std::vector<std::string> ids;
  for (const Json& sheet : answer.fields["sheets"]) {
    const auto read = protocol::formats::read_document(sheet["marker"]);
    demand(static_cast<bool>(read), "the marker of a sheet cannot be read");
    demand(is_valid(read->marker), "the marker of a sheet is not valid");
    for (const Piece& piece : read->marker.pieces) {
      if (!piece.rules.zone) ids.push_back(piece.id);
    }
  }
  for (const Json& id : answer.fields["leftOver"]) ids.push_back(id.get<std::string>());
  judge_ids(std::move(ids));
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage;
  using namespace selvage::test;
  if (size == 0) return 0;
  const auto params = protocol::json::parse(std::string{bytes + 1, bytes + size});
  if (!params || !params->is_object()) return 0;
  const bool sheets = bytes[0] % 2 == 1;
  static const MarkerFile kFiles[] = {file_with(true), file_with(false)};
  const protocol::calls::Method& method = *protocol::methods::find_method(sheets ? "marker.nestSheets" : "marker.nest");
  Json given = *params;
  given["markerId"] = "m1";
  given["moves"] = kMoves;
  for (const char* time : {"seconds", "accuracy", "searches"}) given.erase(time);
  const auto call = method.read(given);
  if (!call) {
    demand(!call.error().message.empty() && call.error().field.starts_with("/"), "an error without its field");
    return 0;
  }
  SumCache sums;
  const auto answer = call->run(kFiles[sheets ? 1 : 0], protocol::calls::MethodContext{scene::Run{sums}});
  if (!answer) {
    demand(!answer.error().message.empty(), "an error without a message");
  } else if (sheets) {
    judge_sheets(*answer);
  } else {
    judge_nest(*answer);
  }
  return 0;
}
