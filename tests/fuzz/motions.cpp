// Fuzz target: random motions on a random marker, both derived from the fuzzer's bytes.  It is the soak test guided by
// code coverage.
#include "tests/fuzz/entry.h"
#include "tests/soak/life.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace selvage::test;
  Random random{std::span{bytes, size}};
  selvage::SumCache sums;
  const Life life = live(constrained_marker(random), 6, random, sums);
  if (life.fault) demand(false, life.fault->motion + ": " + life.fault->what);
  return 0;
}
