// Motions on a marker, both made of the bytes: a soak that looks for ways through the code.
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
