// Fuzz target: reading text as a pattern file.
#include <string>

#include "tests/fuzz/entry.h"
#include "tests/fuzz/trade/sound_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text{bytes, bytes + size};
  selvage::protocol::trade::ReadingOptions options;
  options.unit = selvage::protocol::trade::LengthUnit::kMillimetre;
  // Half pieces are unfolded, or laid on the fold of cloth in two layers.
  if (size % 2 == 1) options.fold = selvage::protocol::trade::FoldRule::kLay;
  selvage::test::demand_sound_file(text, options);
  return 0;
}
