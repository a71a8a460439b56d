// Fuzz target: reading text as an order, and making its bundles.
#include <string>

#include "tests/fuzz/entry.h"
#include "tests/fuzz/trade/sound_reading.h"
#include "tests/support/repository.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::string style = selvage::test::repository_text("examples/trade/polypattern_like.dxf");
  selvage::protocol::trade::ReadingOptions options;
  options.order = std::string{bytes, bytes + size};
  selvage::test::demand_sound_file(style, options);
  return 0;
}
