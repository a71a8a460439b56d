// A path of lines, arcs and Bezier curves, which is flattened to a run of points while it is drawn.
//
// Every chord lies within the tolerance of its curve, and so does the apex that is kept with it (loops.h), from which
// an outline is made that contains the true one.  Units: those of the drawing.
#pragma once

#include "protocol/trade/flattening.h"
#include "protocol/trade/loops.h"

namespace selvage::protocol::trade {

class Path {
 public:
  // `flattening` outlives the path.  When it is exhausted, curves are left out.
  Path(document::Spot start, Flattening& flattening, std::size_t line);

  void line_to(document::Spot to);
  // A chord of a curve that the caller flattens.
  void chord_to(document::Spot to);
  void cubic_to(document::Spot first, document::Spot second, document::Spot to);
  // centre + u cos(t) + v sin(t), t from `from` to `from + sweep` radians; the path is at its start already.
  void arc(document::Spot centre, document::Spot u, document::Spot v, double from, double sweep);
  [[nodiscard]] document::Spot end() const { return run_.points.back(); }
  [[nodiscard]] Run take(bool closed);

 private:
  struct Cubic {
    document::Spot from, first, second, to;
  };
  void add(document::Spot to, Edge edge);
  void flatten(const Cubic& cubic, int depth);

  Flattening& flattening_;
  Run run_;
};

}  // namespace selvage::protocol::trade
