// Fuzz target: reading text as a pattern file.
#include <string>

#include "tests/fuzz/entry.h"
#include "tests/fuzz/trade/sound_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text{bytes, bytes + size};
  selvage::protocol::trade::ReadingOptions options;
  options.unit = selvage::protocol::trade::LengthUnit::kMillimetre;
  selvage::test::demand_sound_file(text, options);
  return 0;
}
