// The tuning constants of dragging: chosen so that one move of a drag takes a few milliseconds on a large marker
// (docs/measurements/daemon.md).  The answer is proved whatever they are.
#pragma once

#include "core/geometry/lattice.h"

namespace selvage::motion::dragging {

struct DragTuning {
  int steps{64};         // positions tried on the straight way from where the piece is to where it is wanted
  int refinements{12};   // bisections of the last step that is free
  int slides{4};         // bumps along contacts, each ending nearer to the wanted position
  double reach{0.1};     // part of the width: pieces this near to the way make room
  int rounds{4};         // of the position model
  double penalty{1e-3};  // displacement penalty of the other pieces, relative to the dragged piece's force
  double least_trust{0.01}, most_trust{0.05};  // trust radius of a round, parts of the width
  Coord there{2};                              // lattice units: as near to the wanted position as rounding allows
};

}  // namespace selvage::motion::dragging
