#include "tests/fuzz/entry.h"

#include <cstdlib>
#include <iostream>

namespace selvage::test {

void demand(bool holds, std::string_view otherwise) {
  if (holds) return;
  std::cerr << "broken: " << otherwise << std::endl;
  std::abort();
}

}  // namespace selvage::test
