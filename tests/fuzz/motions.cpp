// Fuzz target: random motions on a random marker, both derived from the fuzzer's bytes.  It is the soak test guided by
// code coverage.
#include "tests/fuzz/entry.h"
#include "tests/soak/motion_sequence.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage::test;
  Random random{std::span{bytes, size}};
  selvage::SumCache sums;
  const SequenceResult result = run_sequence(constrained_marker(random), 6, random, sums);
  if (result.fault) demand(false, result.fault->motion + ": " + result.fault->what);
  return 0;
}
