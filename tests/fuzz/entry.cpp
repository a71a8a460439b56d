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

// LeakSanitizer looks this function up by name.  Clp's presolve leaks 16 bytes when it abandons a doubleton (CoinUtils,
// doubleton_action::presolve).
extern "C" const char* __lsan_default_suppressions() {  // NOLINT(bugprone-reserved-identifier)
  return "leak:presolve_dupmajor\n";
}
