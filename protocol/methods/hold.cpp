// marker.hold: what holds a marker's length.
#include <array>

#include "core/motion/hold.h"
#include "protocol/codec.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/families.h"
#include "protocol/methods/reading.h"

namespace selvage {
namespace {

constexpr std::string_view kEdgeNames[] = {"left", "right", "bottom", "top"};  // by Edge

Json contacts_json(const Marker& marker, const std::vector<LoadedContact>& contacts) {
  Json list = Json::array();
  for (const LoadedContact& contact : contacts) {
    Json told{{"piece", marker.pieces[contact.first.value].id}};
    if (contact.second) {
      told["other"] = marker.pieces[contact.second->value].id;
    } else {
      told["edge"] = kEdgeNames[static_cast<std::size_t>(contact.edge)];
    }
    told["worth"] = contact.worth;
    told["at"] = Json::array({in_unit(contact.at.x, marker.resolution), in_unit(contact.at.y, marker.resolution)});
    list.push_back(std::move(told));
  }
  return list;
}

Json tilts_json(const Marker& marker, const std::vector<TiltWorth>& tilts) {
  Json list = Json::array();
  for (const TiltWorth& tilt : tilts) {
    list.push_back(
        {{"piece", marker.pieces[tilt.piece.value].id}, {"perDegree", in_unit(tilt.per_degree, marker.resolution)}});
  }
  return list;
}

Result<MethodAnswer> run(const MarkerStudy&, const MarkerFile& file, const Means& means) {
  const auto hold = what_holds(file.marker, means.sums, means.stop, means.observer);
  if (!hold) return hold.error();
  return MethodAnswer{{{"length", to_decimal(length_of(file.marker), file.marker.resolution)},
                       {"contacts", contacts_json(file.marker, hold->contacts)},
                       {"tilts", tilts_json(file.marker, hold->tilts)},
                       {"perSpacing", hold->per_spacing}},
                      std::nullopt};
}

constexpr std::array kResults{
    Word{"length", "number", kRequired, "The marker's."},
    Word{"contacts", "LoadedContact[]", kRequired, "The contacts that carry load, from left to right."},
    Word{"tilts", "TiltWorth[]", kRequired, "What tilting a piece would bring, the most telling first."},
    Word{"perSpacing", "number", kRequired, "What a unit less of spacing would bring."},
};

constexpr std::array kMethods{MarkerMethod{"marker.hold",
                                           MethodKind::kStudy,
                                           &read_reading<decode_marker_study, run>,
                                           {"What holds the length of the marker.", {}, kResults}}};

}  // namespace

std::span<const MarkerMethod> holding_methods() {
  return kMethods;
}

}  // namespace selvage
