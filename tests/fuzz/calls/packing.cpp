// Fuzz target: the first bytes choose an exact search and a marker, the rest is the text of the search's parameters.
// The marker has a placed, a locked and two unplaced pieces.
//
// An answer must be valid, a bound must not exceed the length, and pieces may only move if a layout was found.
#include <algorithm>
#include <array>
#include <string>

#include "protocol/calls/method.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/method_table.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

constexpr std::array kMethods{"motion.pack", "motion.contain", "marker.fillGaps", "marker.compactExactly"};
constexpr std::array kLimits{"nodes", "trials", "windows"};

// Some outlines are not convex, and the shapes allow different sets of orientations.
const MarkerFile& file() {
  static const MarkerFile kFile = *protocol::formats::read_marker(R"({
    "format": "selvage-marker", "version": 1, "strip": {"width": 60, "longest": 400},
    "shapes": [
      {"id": "u", "outline": [[0, 0], [30, 0], [30, 10], [10, 10], [10, 20], [30, 20], [30, 30], [0, 30]],
       "rotations": [0, 90, 180]},
      {"id": "wedge", "outline": [[0, 0], [20, 0], [0, 10]], "rotations": [0, 180], "flip": true}],
    "pieces": [{"id": "a", "shape": "u", "at": [0, 0]}, {"id": "b", "shape": "u", "at": [40, 5], "locked": true},
               {"id": "c", "shape": "wedge", "at": [80, 20]}],
    "unplaced": [{"id": "d", "shape": "wedge"}, {"id": "e", "shape": "wedge"}]})");
  return kFile;
}

// The parameters with lower limits for the search, as far as the method has such limits.
Json limited(const protocol::calls::Method& method, Json params) {
  for (const char* limit : kLimits) {
    const bool had = params.contains(limit);
    const Json was = had ? params[limit] : Json{};
    params[limit] = 40;
    if (method.read(params)) continue;
    params.erase(limit);
    if (had) params[limit] = was;
  }
  return params;
}

void judge(const protocol::calls::MethodAnswer& answer) {
  const Json& fields = answer.fields;
  demand(fields["valid"] == true, "an answer is not valid");
  demand(fields["lengthAfter"].number() >= 0, "a negative length");
  if (fields.contains("bound") && fields["found"] == true) {
    demand(fields["bound"].number() <= fields["lengthAfter"].number(), "a bound above the length");
  }
  const bool lost = fields.contains("verdict") ? fields["verdict"] != "found" : fields.value("found", true) == false;
  demand(!lost || (fields["placements"].empty() && !answer.next), "a search that found nothing moved pieces");
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage;
  using namespace selvage::test;
  if (size == 0) return 0;
  const auto params = protocol::json::parse(std::string{bytes + 1, bytes + size});
  if (!params || !params->is_object()) return 0;
  const protocol::calls::Method& method = *protocol::methods::find_method(kMethods[bytes[0] % kMethods.size()]);
  Json given = *params;
  given["markerId"] = "m1";
  const auto call = method.read(limited(method, std::move(given)));
  if (!call) {
    demand(!call.error().message.empty() && call.error().field.starts_with("/"), "an error without its field");
    return 0;
  }
  SumCache sums;
  const auto answer = call->run(file(), protocol::calls::MethodContext{scene::Run{sums}});
  if (answer) judge(*answer);
  if (!answer) demand(!answer.error().message.empty(), "an error without a message");
  return 0;
}
