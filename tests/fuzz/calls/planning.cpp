// Fuzz target: the text of the parameters of plan.cut, on a style of rectangles in two sizes.
//
// A plan must deliver the order within its limits, and its bound must not exceed its cost.
#include <string>

#include "protocol/calls/method.h"
#include "protocol/json/json_text.h"
#include "protocol/methods/method_table.h"
#include "tests/fuzz/entry.h"

namespace selvage::test {
namespace {

const MarkerFile& style() {
  static const MarkerFile kStyle = *protocol::formats::read_marker(R"({
    "format": "selvage-marker", "version": 1, "strip": {"width": 100},
    "shapes": [{"id": "S", "outline": [[0, 0], [40, 0], [40, 50], [0, 50]], "attributes": {"size": "S"}},
               {"id": "M", "outline": [[0, 0], [50, 0], [50, 50], [0, 50]], "attributes": {"size": "M"}}],
    "pieces": [], "unplaced": [{"id": "s", "shape": "S"}, {"id": "m", "shape": "M"}]})");
  return kStyle;
}

void judge(const Json& params, const Json& plan) {
  const double over = params.value("overCut", 0.03), under = params.value("underCut", 0.0);
  for (const Json& one : plan["delivered"]) {
    const double ordered = one["ordered"].number(), cut = one["cut"].number();
    demand(cut >= ordered * (1 - under) - 1e-6, "fewer garments are cut than allowed");
    demand(cut <= ordered * (1 + over) + 1 + 1e-6, "more garments are cut than allowed");
  }
  demand(plan["bound"].number() <= plan["cost"]["total"].number() * (1 + 1e-9), "the bound is above the cost");
  for (const Json& remnant : plan["remnants"]) {
    const double length = remnant["length"].number();
    demand(remnant["used"].number() <= length * (1 + 1e-9) + 1e-3, "more of a remnant is used than there is");
  }
}

}  // namespace
}  // namespace selvage::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage;
  auto params = protocol::json::parse(std::string{bytes, bytes + size});
  if (!params || !params->is_object()) return 0;
  // Limits the work to less than the parameters may request.
  (*params)["markerId"] = "m1";
  (*params)["rounds"] = 1;
  (*params)["mostMade"] = 0;
  (*params)["movesPerPiece"] = 0;
  if (params->contains("bundles")) (*params)["bundles"] = 2;
  const auto call = protocol::methods::find_method("plan.cut")->read(*params);
  if (!call) return 0;
  SumCache sums;
  const scene::Run run{sums};
  const auto answer = call->run(test::style(), protocol::calls::MethodContext{run});
  if (answer) test::judge(*params, answer->fields);
  return 0;
}
