#include "protocol/methods/readings/reading.h"

#include <array>

#include "protocol/calls/call_fields.h"
#include "protocol/calls/codec.h"
#include "protocol/json/fields.h"
#include "protocol/methods/readings/families.h"

namespace selvage::protocol::methods::readings {
namespace {

Result<calls::MethodAnswer> get(const MarkerGet& wanted, const MarkerFile& file, const calls::MethodContext&) {
  auto document = formats::marker_document(file, wanted.format);
  if (!document) return document.error();
  return calls::MethodAnswer{{{"format", name_of(wanted.format)}, {"marker", *std::move(document)}}, std::nullopt};
}

Result<calls::MethodAnswer> tell_validity(const MarkerStudy&, const MarkerFile& file,
                                          const calls::MethodContext& context) {
  const auto validity = context.engine.check(file.marker, context.run.sums, context.run.stop);
  if (!validity) return validity.error();
  return calls::MethodAnswer{calls::validity_json(file.marker, *validity), std::nullopt};
}

constexpr std::array kGetParams{
    calls::Word{"format", "Format", calls::kOptional, "The form of the document; native when absent."},
    calls::Word{"since", "integer", calls::kOptional, "A revision: only what changed after it, where that is known."},
};
constexpr std::array kGetResults{
    calls::Word{"format", "Format", calls::kOptional, "The form of the document."},
    calls::Word{"marker", "object|string", calls::kOptional,
                "The document; for svg a string. Absent when the answer is by since."},
    calls::Word{"since", "integer", calls::kOptional, "The revision asked from."},
    calls::Word{"placements", "PieceState[]", calls::kOptional, "The pieces that changed after it."},
};
constexpr std::array kCheckResults{
    calls::Word{"valid", "boolean", calls::kRequired, "Proved in integers."},
    calls::Word{"overlaps", "Overlap[]", calls::kRequired, "Pairs that overlap or are too close."},
    calls::Word{"protrusions", "Protrusion[]", calls::kRequired, "Pieces that leave the strip."},
};

constexpr std::array kMethods{
    calls::MarkerMethod{"marker.get",
                        calls::MethodKind::kTell,
                        &read_reading<decode_marker_get, get>,
                        {"A marker as a document.", kGetParams, kGetResults}},
    calls::MarkerMethod{"marker.check",
                        calls::MethodKind::kStudy,
                        &read_reading<decode_marker_study, tell_validity>,
                        {"Is the marker valid, and where not?", {}, kCheckResults}},
};

}  // namespace

Result<MarkerGet> decode_marker_get(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MarkerGet get;
  get.marker_id = fields.text("markerId");
  get.since = calls::read_revision(fields, "since");
  get.format =
      static_cast<Format>(fields.word_or("format", static_cast<std::size_t>(get.format), document::kFormatNames));
  fields.finish();
  if (mistake) return mistake.error();
  return get;
}

Result<MarkerStudy> decode_marker_study(const Json& params) {
  json::Mistake mistake;
  json::Fields fields{params, "", mistake};
  MarkerStudy study{fields.text("markerId"), calls::read_deadline(fields)};
  fields.finish();
  if (mistake) return mistake.error();
  return study;
}

std::span<const calls::MarkerMethod> reading_methods() {
  return kMethods;
}

}  // namespace selvage::protocol::methods::readings
