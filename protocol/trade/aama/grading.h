// Makes the sizes of a style that is drawn only in its sample size, with its rule table.
//
// A point "# n" moves by rule n, along the grade reference (layer 5; the file's x axis when there is none).  The
// standard does not define the movement between two graded points: here a vertex moves by the mean of its two graded
// neighbours' movements, weighted by the arc length to them.  Annotations move by their own rules if they have any,
// otherwise with the nearest vertex of the outline.  Units: millimetres.
#pragma once

#include <vector>

#include "protocol/trade/aama/blocks/pattern_block.h"
#include "protocol/trade/rules/rule_table.h"

namespace selvage::protocol::trade::aama {

// `size` is the position of the size in the table; `unit` is that of the table, in millimetres.
// Every oddity is noted once for each block: call it with `notes` for one size only.
void grade(PatternBlock& block, std::vector<Spot>& outline, const rules::RuleTable& table, std::size_t size,
           double unit, std::vector<Note>* notes);

}  // namespace selvage::protocol::trade::aama
