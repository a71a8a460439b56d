// Fuzz target: reading text as a plot.
#include <string>

#include "tests/fuzz/entry.h"
#include "tests/fuzz/trade/sound_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text{bytes, bytes + size};
  selvage::protocol::trade::ReadingOptions options;
  selvage::test::demand_sound_file(text, options);
  return 0;
}
