// The mixed integer program of [Li94 8.2], as a baseline for the search: one binary variable for every set of a convex
// covering of every ring, one of them 1, and the lines of a set as rows that hold when its variable is 1 (8.2).
//
// The constant of each row is the smallest that disables it anywhere in the strip.  Units: widths of the room.
#pragma once

#include "core/lp/integer/integer_program.h"
#include "core/packing/branching/problem.h"
#include "core/packing/coverings/covering.h"

namespace selvage::bench {

using Cover = std::vector<packing::coverings::ConvexSet> (*)(const packing::cells::WedgeRing&);

struct ThesisProgram {
  lp::integer::IntegerProgram program;
  double unit{};  // lattice units in a unit of the program
};

// The program of the layouts up to a length, in lattice units.  REQUIRES: every body has one variant, and the length is
// minimised.
[[nodiscard]] ThesisProgram thesis_program(const packing::branching::Problem& problem, Cover cover, double longest);

}  // namespace selvage::bench
