#include "tests/support/garment.h"

#include <fstream>
#include <sstream>

#include "protocol/formats/format.h"

namespace selvage::test {

Marker garment(const std::string& name) {
  std::ifstream file{std::string{SELVAGE_SOURCE_DIR} + "/examples/markers/" + name + ".json"};
  std::stringstream text;
  text << file.rdbuf();
  auto read = protocol::formats::read_marker(text.str());
  EXPECT_TRUE(read) << name;
  return read ? std::move(read->marker) : Marker{};
}

}  // namespace selvage::test
