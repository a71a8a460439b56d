// A linear program divided along its structure: domains, whose columns share no row with each other's, and a border of
// a few columns, which occur in the rows of several domains.
//
// Position models of long markers divide well: a piece has rows only with the pieces around it, so the pieces at a few
// places along the strip separate all others.  How many domains there are depends on the size of the program, never on
// the threads that work on them.
#pragma once

#include <vector>

#include "core/lp/linear_program.h"

namespace selvage::lp::interior_point {

struct Division {
  struct Domain {
    std::vector<int> columns;  // of the program: first its own, then those of the border that its rows have
    int own{};                 // the number of its own columns
    std::vector<int> border;   // of each of the other columns, its index in the border
    std::vector<int> rows;     // ascending
  };
  std::vector<Domain> domains;  // none: the program is not divided
  std::vector<int> border;      // columns, ascending
  std::vector<int> owner;       // of each column of the border, the domain that has its cost and its bounds
};

// Laws.  (1) Every row belongs to one domain, and all its columns are that domain's; columns that cannot move belong to
// none.  (2) Every other column is some domain's own, or in the border.
//
// A domain has about `size` pieces, or other groups of consecutive columns that occur in the same rows.  Programs that
// would have fewer than two domains are not divided.  REQUIRES: size > 0.
[[nodiscard]] Division division(const LinearProgram& program, int size);

// The program of a domain, with its columns and rows in their order.  Columns of the border have costs and bounds at
// their owner alone.
[[nodiscard]] LinearProgram domain_program(const LinearProgram& program, const Division& division, std::size_t domain);

}  // namespace selvage::lp::interior_point
