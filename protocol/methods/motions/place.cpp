// motion.place: a piece dropped anywhere goes to the nearest free position, all others still.
#include "core/motion/placing/place.h"

#include <array>

#include "protocol/calls/motion.h"
#include "protocol/calls/places.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/families.h"

namespace selvage::protocol::methods::motions {
namespace {

// motion.place {"piece", "to", "mayGrow"?}
struct MotionPlace {
  calls::MotionCall call;
  std::string piece;
  formats::Decimal to;
  motion::placing::PlaceSettings settings;
};

Result<MotionPlace> decode(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MotionPlace wanted;
  wanted.call = calls::read_call(fields, mistake);
  wanted.piece = fields.id("piece");
  wanted.to = calls::read_place(fields, "to", mistake);
  wanted.settings.may_grow = fields.flag_or("mayGrow", wanted.settings.may_grow);
  fields.finish();
  if (mistake) return mistake.error();
  return wanted;
}

Result<calls::Motion> run(const MotionPlace& wanted, const Marker& start, const calls::MethodContext& context) {
  const auto piece = calls::piece_of(start, wanted.piece, "/piece");
  if (!piece) return piece.error();
  const auto to = calls::place_on_lattice(wanted.to, start.resolution, "/to");
  if (!to) return to.error();
  auto done = heal_and_place(start, *piece, *to, wanted.settings, context.run);
  if (!done) return done.error();
  const Vec at = done->marker.pieces[piece->value].at;
  Json figures{{"found", done->place.has_value()},
               {"at", formats::point_json(at, start.resolution)},
               {"distance", done->place ? Json(formats::in_unit(done->place->distance, start.resolution)) : Json{}},
               {"grown", done->place && done->place->grown},
               {"stop", calls::name_of(scene::StopReason::kConverged)}};
  return calls::Motion{std::move(done->marker), std::move(figures), done->repair};
}

constexpr std::array kParams{
    calls::Word{"piece", "Id", calls::kRequired, "The piece's id."},
    calls::Word{"to", "Point", calls::kRequired, "Where its origin is wanted."},
    calls::Word{"mayGrow", "boolean", calls::kOptional, "When nothing within the marker's length is free, beyond it."},
};
constexpr std::array kResults = together(
    std::array{
        calls::Word{"found", "boolean", calls::kRequired, "There is a free position; without one the piece stays."},
        calls::Word{"at", "Point", calls::kRequired, "Where its origin now lies; exact."},
        calls::Word{"distance", "number|null", calls::kRequired, "From the wanted place; null when none was found."},
        calls::Word{"grown", "boolean", calls::kRequired, "The marker had to become longer."},
    },
    calls::kStopResults);

constexpr std::array kMethods{
    calls::MarkerMethod{"motion.place",
                        calls::MethodKind::kStep,
                        &calls::read_motion<decode, run>,
                        {"A piece dropped anywhere goes to the nearest free position.", kParams, kResults}}};

}  // namespace

std::span<const calls::MarkerMethod> placing_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::motions
