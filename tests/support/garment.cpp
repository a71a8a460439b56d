#include "tests/support/garment.h"

#include "protocol/formats/format.h"
#include "tests/support/repository.h"

namespace selvage::test {

Marker garment(const std::string& name) {
  auto read = protocol::formats::read_marker(garment_text(name));
  EXPECT_TRUE(read) << name;
  return read ? std::move(read->marker) : Marker{};
}

}  // namespace selvage::test
