// Messages that are no sound calls: golden requests with something wrong in them, and what never was one.
#pragma once

#include <string>
#include <vector>

#include "protocol/json/json_text.h"
#include "tests/support/random.h"

namespace selvage::trials {

class MalformedMessages {
 public:
  explicit MalformedMessages(std::uint64_t seed);

  // The next one, as one line.  `marker_id` is the marker that golden requests about "m1" are made to name: what is
  // only a little wrong with them comes far.  Each gets exactly one answer; those that would get none, as they are
  // notifications or blank, are passed over.  A few turn out to be sound.
  [[nodiscard]] std::string next(const std::string& marker_id);

 private:
  std::string damaged_text(std::string text);
  std::string with_odd_number(Json request);
  std::string with_odd_field(Json request);
  std::string random_bytes();

  test::Random random_;
  std::vector<Json> golden_;
};

// The few that are large: nested up to 10^7 deep, and as long as the daemon takes (`limit` bytes) and longer.
// Made one at a time, as together they would not fit.
inline constexpr std::size_t kExtremes = 11;
[[nodiscard]] std::string extreme_message(std::size_t which, std::size_t limit);

}  // namespace selvage::trials
