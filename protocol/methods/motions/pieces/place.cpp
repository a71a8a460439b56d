// motion.place: a piece moves to the free position nearest to a given one; all others stay.
#include "core/motion/placing/place.h"

#include "protocol/calls/motion.h"
#include "protocol/formats/decimal_marker.h"

namespace selvage::protocol::methods::motions::pieces {
namespace {

struct PlaceParams {
  calls::CommonParams call;
  calls::Id piece;
  calls::Point to;
  motion::placing::PlaceSettings settings;

  static void describe(auto& v, auto& self) {
    v.part(self.call);
    v.required("piece", self.piece, calls::kPieceMeaning);
    v.required("to", self.to, "The wanted position of the piece's origin.");
    v.optional("mayGrow", self.settings.may_grow,
               "When there is no free position within the marker's length, allow one beyond it.");
  }
};

struct PlaceResult {
  bool found{};
  calls::Point at;
  std::optional<double> distance;
  bool grown{};
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("found", self.found, "Whether there is a free position; without one the piece stays.");
    v.required("at", self.at, "The new position of the piece's origin; exact.");
    v.required("distance", self.distance, "Its distance from the wanted position; null when none was found.");
    v.required("grown", self.grown, "Whether the marker became longer.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

Result<calls::Motion<PlaceResult>> run_place(const PlaceParams& params, const Marker& start,
                                             const calls::MethodContext& context) {
  const auto piece = calls::piece_of(start, params.piece.text, "/piece");
  if (!piece) return piece.error();
  const auto to = calls::place_on_lattice(params.to, start.resolution, "/to");
  if (!to) return to.error();
  auto done = repair_and_place(start, *piece, *to, params.settings, context.run);
  if (!done) return done.error();
  PlaceResult result{.found = done->place.has_value(),
                     .at = calls::point_of(done->marker.pieces[piece->value].at, start.resolution),
                     .distance = {},
                     .grown = done->place && done->place->grown,
                     .stop = calls::stop_cause(done->reason, context)};
  if (done->place) result.distance = formats::in_unit(done->place->distance, start.resolution);
  return calls::Motion<PlaceResult>{{std::move(done->marker), done->repair}, result};
}

}  // namespace

calls::Method place_method() {
  return calls::motion_method("motion.place", calls::MethodKind::kStep,
                              "Moves a piece to the free position nearest to a given one.", run_place);
}

}  // namespace selvage::protocol::methods::motions::pieces
