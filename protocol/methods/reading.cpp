#include "protocol/methods/reading.h"

#include <array>

#include "protocol/call_fields.h"
#include "protocol/codec.h"
#include "protocol/fields.h"
#include "protocol/methods/families.h"

namespace selvage {
namespace {

Result<MethodAnswer> get(const MarkerGet& wanted, const MarkerFile& file, const Means&) {
  auto document = marker_document(file, wanted.format);
  if (!document) return document.error();
  return MethodAnswer{{{"format", name_of(wanted.format)}, {"marker", *std::move(document)}}, std::nullopt};
}

Result<MethodAnswer> tell_validity(const MarkerStudy&, const MarkerFile& file, const Means& means) {
  const auto validity = means.engine.check(file.marker, means.sums, means.stop);
  if (!validity) return validity.error();
  return MethodAnswer{validity_json(file.marker, *validity), std::nullopt};
}

constexpr std::array kGetParams{
    Word{"format", "Format", kOptional, "The form of the document; native when absent."},
    Word{"since", "integer", kOptional, "A revision: only what changed after it, where that is known."},
};
constexpr std::array kGetResults{
    Word{"format", "Format", kOptional, "The form of the document."},
    Word{"marker", "object|string", kOptional, "The document; for svg a string. Absent when the answer is by since."},
    Word{"since", "integer", kOptional, "The revision asked from."},
    Word{"placements", "PieceState[]", kOptional, "The pieces that changed after it."},
};
constexpr std::array kCheckResults{
    Word{"valid", "boolean", kRequired, "Proved in integers."},
    Word{"overlaps", "Overlap[]", kRequired, "Pairs that overlap or are too close."},
    Word{"protrusions", "Protrusion[]", kRequired, "Pieces that leave the strip."},
};

constexpr std::array kMethods{
    MarkerMethod{"marker.get",
                 MethodKind::kTell,
                 &read_reading<decode_marker_get, get>,
                 {"A marker as a document.", kGetParams, kGetResults}},
    MarkerMethod{"marker.check",
                 MethodKind::kStudy,
                 &read_reading<decode_marker_study, tell_validity>,
                 {"Is the marker valid, and where not?", {}, kCheckResults}},
};

}  // namespace

Result<MarkerGet> decode_marker_get(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MarkerGet get;
  get.marker_id = fields.text("markerId");
  get.since = read_revision(fields, "since");
  get.format = static_cast<Format>(fields.word_or("format", static_cast<std::size_t>(get.format), kFormatNames));
  fields.finish();
  if (mistake) return mistake.error();
  return get;
}

Result<MarkerStudy> decode_marker_study(const Json& params) {
  Mistake mistake;
  Fields fields{params, "", mistake};
  MarkerStudy study{fields.text("markerId"), read_deadline(fields)};
  fields.finish();
  if (mistake) return mistake.error();
  return study;
}

std::span<const MarkerMethod> reading_methods() {
  return kMethods;
}

}  // namespace selvage
