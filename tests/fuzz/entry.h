// The entry point of every fuzz target, and the function by which a target reports a failure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// Called by libFuzzer with generated inputs, and by replay_corpus.cpp with the saved corpus.  Always returns 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace selvage::test {

// Unless `holds` is true, crashes the process so that the fuzzer saves the input.
void demand(bool holds, std::string_view otherwise);

}  // namespace selvage::test
