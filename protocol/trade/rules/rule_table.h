// The grade rule table of a style (.rul): how far every graded point moves from the sample size to each other size
// [ASTM D6673].
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::rules {

struct RuleTable {
  std::string name, sample_size;
  std::string units;                           // "METRIC" or "ENGLISH"; empty: the table does not say
  std::vector<std::string> sizes;              // in the table's order
  std::map<int, std::vector<Spot>> movements;  // by the rule's number: one per size, in the table's unit
  std::vector<Note> notes;
};

// Numbers may be separated by commas, semicolons, blanks and line ends.  A comma is a decimal comma, with a note, when
// every rule then has as many numbers as the sizes need, and some rule does not if commas are separators.  Lines that
// begin with ; # * or // are comments.
// Errors: kUnknownFormat (no list of sizes), kSyntax (a rule without a number, or with too few or too many), with the
// line.
[[nodiscard]] Result<RuleTable> read_rule_table(std::string_view text);

}  // namespace selvage::protocol::trade::rules
