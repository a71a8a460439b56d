// The entry point of every fuzz target, and the functions by which a target reports a failure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ctime>
#include <string_view>

// Called by libFuzzer with generated inputs, and by replay_corpus.cpp with the saved corpus.  Always returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace selvage::test {

// Unless `holds` is true, crashes the process so that the fuzzer saves the input.
void demand(bool holds, std::string_view otherwise);

// The result of `read`, which must not take more than a second of processor time.  libFuzzer's own limit is of real
// time, which a busy machine exceeds with any input.
template <class Read>
auto within_a_second(const Read& read) {
  const std::clock_t begun = std::clock();
  auto result = read();
  demand(std::clock() - begun <= CLOCKS_PER_SEC, "an input took more than a second of processor time");
  return result;
}

}  // namespace selvage::test
