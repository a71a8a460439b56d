// Time of the proof that a marker is valid: in the core, from a marker value without a prepared layout, and as the
// method marker.check, from the text of its parameters to the text of its result.
#include <benchmark/benchmark.h>

#include "bench/support/example_markers.h"
#include "core/marker/validity.h"
#include "protocol/calls/answer.h"
#include "protocol/methods/method_table.h"

namespace selvage::bench {
namespace {

void prove(benchmark::State& state, const std::string& name) {
  const Marker marker = example_marker(name);
  for (auto _ : state) {
    if (!is_valid(marker)) state.SkipWithError("not valid");
  }
}

void check_method(benchmark::State& state, const std::string& name) {
  const MarkerFile file{.marker = example_marker(name), .format = Format::kNative, .notes = {}, .attributes = {}};
  const protocol::calls::Method& method = *protocol::methods::find_method("marker.check");
  for (auto _ : state) {
    SumCache sums;
    const auto call = method.read(*protocol::json::parse(R"({"markerId":"m1"})"));
    const scene::Run run{sums};
    const auto answer = call->run(file, protocol::calls::MethodContext{run});
    if (answer->fields["valid"] != true) state.SkipWithError("not valid");
    benchmark::DoNotOptimize(protocol::json::to_text(protocol::calls::result_json("m1", 1, answer->fields)));
  }
}

void register_all() {
  for (const char* name : {"jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g"}) {
    const std::string label = name;
    benchmark::RegisterBenchmark((label + "/proof").c_str(), prove, label)->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark((label + "/marker.check").c_str(), check_method, label)->Unit(benchmark::kMillisecond);
  }
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  selvage::bench::register_all();
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
