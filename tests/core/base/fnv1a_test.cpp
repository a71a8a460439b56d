// The hash that outlines, stored markers and requests are told apart by.  The values are published ones.
#include "core/base/fnv1a.h"

#include <gtest/gtest.h>

namespace selvage {
namespace {

TEST(Fnv1a, HashesBytes) {
  EXPECT_EQ(Fnv1a{}.value(), 0xcbf29ce484222325U);
  EXPECT_EQ(Fnv1a{}.add("a").value(), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(Fnv1a{}.add("foo").add("bar").value(), 0x85944171f73967e8U);
}

TEST(Fnv1a, HashesANumberAsItsEightBytes) {
  EXPECT_EQ(Fnv1a{}.add(std::uint64_t{0x7261626f6f66}).value(), Fnv1a{}.add({"foobar\0\0", 8}).value());
}

}  // namespace
}  // namespace selvage
