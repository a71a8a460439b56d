// Messages that are not valid calls: golden requests with an error in them, and texts that never were calls.
#pragma once

#include <string>
#include <vector>

#include "tests/support/random.h"
#include "tests/trials/live/caller.h"

namespace selvage::trials {

class MalformedMessages {
 public:
  explicit MalformedMessages(std::uint64_t seed);

  // The next message, as one line.  Golden requests about "m1" are changed to name the marker `marker_id`, so that
  // those with small errors pass most of the checks.  Each message gets exactly one answer; those that would get none,
  // because they are notifications or blank, are skipped.  A few turn out to be valid.
  [[nodiscard]] std::string next(const std::string& marker_id);

 private:
  std::string damaged_text(std::string text);
  std::string with_odd_number(Json request);
  std::string with_odd_field(Json request);
  std::string random_bytes();

  test::Random random_;
  std::vector<Json> golden_;
};

// The large messages: nested up to 10^7 deep, and as long as the daemon accepts (`limit` bytes) or longer.  They are
// made one at a time, because together they would not fit into memory.
inline constexpr std::size_t kExtremes = 11;
[[nodiscard]] std::string extreme_message(std::size_t which, std::size_t limit);

}  // namespace selvage::trials
