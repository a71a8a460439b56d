// marker.hold: what holds a marker's length.
#include <array>

#include "core/motion/compaction/critical_path.h"
#include "protocol/calls/codec.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/readings/families.h"
#include "protocol/methods/readings/reading.h"

namespace selvage::protocol::methods::readings {
namespace {

constexpr std::string_view kEdgeNames[] = {"left", "right", "bottom", "top"};  // by Edge

Json contacts_json(const Marker& marker, const std::vector<motion::compaction::LoadedContact>& contacts) {
  Json list = Json::array();
  for (const motion::compaction::LoadedContact& contact : contacts) {
    Json told{{"piece", marker.pieces[contact.first.value].id}};
    if (contact.second) {
      told["other"] = marker.pieces[contact.second->value].id;
    } else {
      told["edge"] = kEdgeNames[static_cast<std::size_t>(contact.edge)];
    }
    told["worth"] = contact.worth;
    told["at"] = Json::array(
        {formats::in_unit(contact.at.x, marker.resolution), formats::in_unit(contact.at.y, marker.resolution)});
    list.push_back(std::move(told));
  }
  return list;
}

Json tilts_json(const Marker& marker, const std::vector<motion::compaction::TiltWorth>& tilts) {
  Json list = Json::array();
  for (const motion::compaction::TiltWorth& tilt : tilts) {
    list.push_back({{"piece", marker.pieces[tilt.piece.value].id},
                    {"perDegree", formats::in_unit(tilt.per_degree, marker.resolution)}});
  }
  return list;
}

Result<calls::MethodAnswer> run(const MarkerStudy&, const MarkerFile& file, const calls::MethodContext& context) {
  const auto hold = motion::compaction::what_holds(file.marker, context.run);
  if (!hold) return hold.error();
  return calls::MethodAnswer{{{"length", to_decimal(length_of(file.marker), file.marker.resolution)},
                              {"contacts", contacts_json(file.marker, hold->contacts)},
                              {"tilts", tilts_json(file.marker, hold->tilts)},
                              {"perSpacing", hold->per_spacing}},
                             std::nullopt};
}

constexpr std::array kResults{
    calls::Word{"length", "number", calls::kRequired, "The marker's."},
    calls::Word{"contacts", "LoadedContact[]", calls::kRequired, "The contacts that carry load, from left to right."},
    calls::Word{"tilts", "TiltWorth[]", calls::kRequired, "What tilting a piece would bring, the most telling first."},
    calls::Word{"perSpacing", "number", calls::kRequired, "What a unit less of spacing would bring."},
};

constexpr std::array kMethods{calls::MarkerMethod{"marker.hold",
                                                  calls::MethodKind::kStudy,
                                                  &read_reading<decode_marker_study, run>,
                                                  {"What holds the length of the marker.", {}, kResults}}};

}  // namespace

std::span<const calls::MarkerMethod> holding_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::readings
