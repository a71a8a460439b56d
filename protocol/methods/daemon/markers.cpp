#include "protocol/methods/daemon/markers.h"

#include <utility>

#include "core/marker/figures.h"
#include "core/marker/validity.h"
#include "protocol/calls/method.h"
#include "protocol/edits/cloth.h"
#include "protocol/files/reading.h"
#include "protocol/methods/daemon/engine.h"
#include "protocol/schema/documents.h"

namespace selvage::protocol::methods::daemon {

// A marker in parameters: a JSON object, or the text of a file.  Valid only as long as the parameters are.
struct SourceView {
  const Json* value{};
};

}  // namespace selvage::protocol::methods::daemon

namespace selvage::protocol::schema {

template <>
struct Wire<methods::daemon::SourceView> {
  static Type type() { return any_document(); }
  static void read(const FieldAt& at, methods::daemon::SourceView& value) {
    value.value = at.fields.required_any(at.key);
    if (!value.value || value.value->is_object() || value.value->is_string()) return;
    at.mistake.add(ErrorCode::kWrongType, json::shortened(*value.value) + " where an object or a text is required",
                   at.pointer());
  }
};

template <>
struct Choices<trade::LengthUnit> {
  static constexpr std::string_view kName = "LengthUnit";
  static constexpr std::string_view kMeaning = "A unit of length.";
  static constexpr auto& kWords = trade::kUnitWords;
};

template <>
struct Choices<trade::FoldRule> {
  static constexpr std::string_view kName = "FoldRule";
  static constexpr std::string_view kMeaning = "What happens to a half piece that is drawn up to its mirror line.";
  static constexpr auto& kWords = trade::kFoldWords;
};

template <>
struct Choices<trade::Nap> {
  static constexpr std::string_view kName = "Nap";
  static constexpr std::string_view kMeaning = "Whether pieces may also be rotated by 180 degrees.";
  static constexpr auto& kWords = trade::kNapWords;
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::daemon {
namespace {

constexpr json::Range kWidths{1, 1e6};         // millimetres
constexpr json::Range kTolerances{1e-4, 100};  // millimetres

// How to read a text.  These options have no effect on JSON documents.
struct ReadingFields {
  static constexpr std::string_view kGroup = "reading";

  static constexpr std::size_t kMostSizes = 1000;

  trade::ReadingOptions options;
  std::optional<std::vector<schema::Id>> sizes;

  static void describe(auto& v, auto& self) {
    v.optional("unit", self.options.unit, "The unit of a pattern or cut file, instead of the one that it states.");
    v.optional("width", self.options.width,
               "The width of the cloth in mm, which a pattern file does not state. 1500 when absent.",
               {.range = kWidths});
    v.optional("sizes", self.sizes, "The sizes of a graded pattern that are read; all when absent.",
               {.entries = {{0, kMostSizes}}, .entries_are = "sizes"});
    v.optional("fold", self.options.fold,
               "Unfold half pieces, keep them as drawn, or lay them on the fold of the cloth, where the two layers "
               "make a pair of every other piece; unfold when absent.");
    v.optional("nap", self.options.nap,
               "Whether pieces of a pattern may be rotated by 180 degrees; one_way when absent.");
    v.optional("tolerance", self.options.tolerance,
               "How far a flattened curve may deviate from the true one, in mm; 0.05 when absent.",
               {.range = kTolerances});
    v.optional("rules", self.options.rules, "The text of a grade rule table, which makes the sizes of a pattern.");
    v.optional("order", self.options.order,
               "The text of an order, in JSON or CSV; the marker gets the pieces of its bundles.");
    v.optional("plain", self.options.plain, "True: every closed outline of a DXF is a piece.");
  }
};

struct OpenFields {
  SourceView marker;
  std::optional<double> spacing, overlap;
  std::optional<std::string> op_id;
  bool close_with_connection{};
  ReadingFields reading;
  edits::Cloth cloth;

  static void describe(auto& v, auto& self) {
    v.required("marker", self.marker,
               "A native or sparrow document, or the text of a file in any format that can be read.");
    v.optional("spacing", self.spacing, "Overrides the document's spacing.");
    v.optional("overlap", self.overlap, "Overrides the document's overlap allowance.");
    v.part(self.reading);
    v.part(self.cloth);
    v.optional("closeWithConnection", self.close_with_connection,
               "True: the marker is closed when the connection that opens it ends. Not over plain HTTP. The engine "
               "without a daemon closes all of its markers when it ends, with or without it.");
    v.optional("opId", self.op_id, calls::kOpIdMeaning, calls::kOpIds);
  }
};

Result<MarkerFile> read_source(const OpenFields& fields) {
  const Json& source = *fields.marker.value;
  if (!source.is_string()) return formats::read_document(source);
  trade::ReadingOptions options = fields.reading.options;
  for (std::size_t k = 0; fields.reading.sizes && k < fields.reading.sizes->size(); ++k)
    options.sizes.push_back((*fields.reading.sizes)[k].text);
  return files::read_file(source.text(), options);
}

// The error of with_cloth points to a parameter or into the marker, which also has a field `shade`.
Error into_parameters(Error error, const edits::Cloth& cloth) {
  const std::string_view field = error.field;
  const bool of_shade = field.starts_with("/shade") && !cloth.shade;
  const bool of_marker = of_shade || field.starts_with("/strip") || field.starts_with("/shapes") ||
                         field.starts_with("/pieces") || field.starts_with("/unplaced");
  return of_marker ? json::within("/marker", std::move(error)) : error;
}

}  // namespace

Result<OpenParams> decode_open(const Json& params) {
  auto fields = schema::decode<OpenFields>(params);
  if (!fields) return fields.error();
  auto file = read_source(*fields);
  if (!file) return json::within("/marker", file.error());
  for (Note& note : file->notes) note.field.insert(0, "/marker");
  if (fields->spacing) file = formats::with_spacing(*std::move(file), *fields->spacing);
  if (file && fields->overlap) file = formats::with_overlap(*std::move(file), *fields->overlap);
  if (!file) return file.error();
  file = edits::with_cloth(*std::move(file), fields->cloth);
  if (!file) return into_parameters(file.error(), fields->cloth);
  return OpenParams{*std::move(file), std::move(fields->op_id), fields->close_with_connection};
}

OpenResult opened(const std::string& marker_id, Revision revision, const MarkerFile& file) {
  const Marker& marker = file.marker;
  return {.at = {marker_id, revision},
          .pieces = piece_count(marker),
          .unplaced = calls::unplaced_count(marker),
          .length = to_decimal(length_of(marker), marker.resolution),
          .utilisation = utilisation_of(marker),
          .valid = is_valid(marker),
          .notes = calls::notes_of(file.notes)};
}

calls::Method open_method() {
  calls::Method method = calls::served_method<OpenFields, OpenResult>("marker.open", calls::MethodKind::kRead,
                                                                      "Opens a marker from a document.");
  method.read = [name = method.name, kind = method.kind](const Json& params) -> Result<calls::ParsedCall> {
    auto wanted = decode_open(params);
    if (!wanted) return wanted.error();
    calls::CommonParams about = calls::common_of(*wanted);
    return calls::ParsedCall{name, kind, std::move(about), *std::move(wanted), nullptr};
  };
  return method;
}

calls::Method list_method() {
  return calls::served_method<NoParams, ListResult>("marker.list", calls::MethodKind::kRead, "Lists the open markers.");
}

calls::Method close_method() {
  return calls::served_method<CloseParams, CloseResult>("marker.close", calls::MethodKind::kRead, "Closes a marker.");
}

calls::Method watch_method() {
  return calls::served_method<MarkerIdParams, WatchResult>("marker.watch", calls::MethodKind::kImmediate,
                                                           "Notifies the connection of every change of a marker.");
}

calls::Method unwatch_method() {
  return calls::served_method<MarkerIdParams, UnwatchResult>("marker.unwatch", calls::MethodKind::kImmediate,
                                                             "Stops change notifications.");
}

}  // namespace selvage::protocol::methods::daemon
