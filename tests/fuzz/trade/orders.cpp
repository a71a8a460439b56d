// Fuzz target: reading text as a an order, and making its bundles.
#include <fstream>
#include <sstream>
#include <string>

#include "tests/fuzz/entry.h"
#include "tests/fuzz/trade/sound_reading.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const std::string style = [] {
    std::ostringstream text;
    text << std::ifstream{std::string{SELVAGE_SOURCE_DIR} + "/examples/trade/polypattern_like.dxf", std::ios::binary}
                .rdbuf();
    return text.str();
  }();
  selvage::protocol::trade::ReadingOptions options;
  options.order = std::string{bytes, bytes + size};
  selvage::test::demand_sound_file(style, options);
  return 0;
}
