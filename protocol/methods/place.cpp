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

constexpr std::array kParams{
    Word{"piece", "Id", kRequired, "The piece's id."},
    Word{"to", "Point", kRequired, "Where its origin is wanted."},
    Word{"mayGrow", "boolean", kOptional, "When nothing within the marker's length is free, beyond it."},
};
constexpr std::array kResults = together(
    std::array{
        Word{"found", "boolean", kRequired, "There is a free position; without one the piece stays."},
        Word{"at", "Point", kRequired, "Where its origin now lies; exact."},
        Word{"distance", "number|null", kRequired, "From the wanted place; null when none was found."},
        Word{"grown", "boolean", kRequired, "The marker had to become longer."},
    },
    kStopResults);

constexpr std::array kMethods{
    MarkerMethod{"motion.place",
                 MethodKind::kStep,
                 &read_motion<decode, run>,
                 {"A piece dropped anywhere goes to the nearest free position.", kParams, kResults}}};

}  // namespace

std::span<const MarkerMethod> placing_methods() {
  return kMethods;
}

}  // namespace selvage
