// Fuzz target: reading text as a marker in the sparrow format.
#include "protocol/formats/sparrow.h"

#include "tests/fuzz/entry.h"
#include "tests/fuzz/formats/marker_text.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const std::string text{bytes, bytes + size};
  selvage::test::demand_sound_reading(text, selvage::protocol::formats::read_sparrow);
  return 0;
}
