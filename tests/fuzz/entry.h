// The entry of every fuzz target, and how it says that something is wrong.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// libFuzzer calls it with whatever it makes up; replay_corpus.cpp with what was kept.  Always 0.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace selvage::test {

// Ends the process with a crash, which the fuzzer keeps, unless `holds`.
void demand(bool holds, std::string_view otherwise);

}  // namespace selvage::test
