// motion.place: a piece dropped anywhere goes to the nearest free position, all others still.
#include "core/motion/place.h"

#include <array>

#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"
#include "protocol/methods/motion.h"
#include "protocol/methods/places.h"

namespace selvage {
namespace {

// motion.place {"piece", "to", "mayGrow"?}
struct MotionPlace {
  MotionCall call;
  std::string piece;
  Decimal to;
  PlaceSettings settings;
};

Result<MotionPlace> decode(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MotionPlace wanted;
  wanted.call = read_call(fields, mistake);
  wanted.piece = fields.id("piece");
  wanted.to = read_place(fields, "to", mistake);
  wanted.settings.may_grow = fields.flag_or("mayGrow", wanted.settings.may_grow);
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<Motion> run(const MotionPlace& wanted, const Marker& start, const Means& means) {
  const auto piece = piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  const auto to = place_on_lattice(wanted.to, start.resolution, "/to");
  if (!to) return to.error();
  auto done = heal_and_place(start, *piece, *to, wanted.settings, means.sums, means.stop, means.observer);
  if (!done) return done.error();
  const Vec at = done->marker.pieces[piece->value].at;
  Json figures{{"found", done->place.has_value()},
               {"at", point_json(at, start.resolution)},
               {"distance", done->place ? Json(in_unit(done->place->distance, start.resolution)) : Json{}},
               {"grown", done->place && done->place->grown},
               {"stop", name_of(StopReason::kConverged)}};
  return Motion{std::move(done->marker), std::move(figures), done->healing};
}

constexpr std::array kMethods{MarkerMethod{"motion.place", true, &read_motion<decode, run>}};

}  // namespace

std::span<const MarkerMethod> placing_methods() {
  return kMethods;
}

}  // namespace selvage
