// marker.nestSheets: nests all pieces of a marker on sheets of given sizes and forms.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/nesting/sheets/nest_on_sheets.h"
#include "protocol/edits/changes.h"
#include "protocol/files/writing.h"
#include "protocol/formats/format.h"
#include "protocol/methods/nesting/nest_params.h"
#include "protocol/methods/nesting/sheet_params.h"
#include "protocol/methods/readings/reading.h"
#include "protocol/schema/documents.h"

namespace selvage::protocol::methods::nesting {
namespace {

struct NestSheetsParams {
  std::string marker_id;
  std::optional<std::vector<SheetParams>> sheets;
  NestEffort effort;
  std::optional<std::vector<PieceValue>> values;
  std::optional<double> deadline_ms;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.optional("sheets", self.sheets,
               "The kinds of sheets that there are, 1 to 100; absent: the bins of the opened file.",
               {.entries = {{1, kMostSheets}}, .entries_are = "kinds of sheets"});
    v.part(self.effort);
    v.optional("values", self.values, kValuesMeaning, {.entries = {{0, marker::kMaxPieces}}, .entries_are = "values"});
    v.optional("deadlineMs", self.deadline_ms,
               "After this many milliseconds the call returns its best result so far; 1 to 86,400,000.",
               calls::kDeadlines);
  }
};

struct NestedSheet {
  static constexpr std::string_view kName = "NestedSheet", kMeaning = "A sheet that is used, with the pieces on it.";
  std::size_t sheet{}, pieces{};
  double utilisation{};
  schema::NativeDocument marker;

  static void describe(auto& v, auto& self) {
    v.required("sheet", self.sheet, "Index of its kind in the parameter, or among the bins that are in stock.");
    v.required("pieces", self.pieces, "Number of pieces on it.");
    v.required("utilisation", self.utilisation, "The pieces' area divided by that of the sheet, 0 to 1.");
    v.required("marker", self.marker,
               "A native document: the strip is the sheet or, with an outline, its bounding box; positions are "
               "measured from its lower left corner.  What pieces may not cover are its zones.");
  }
};

struct NestSheetsResult {
  std::vector<NestedSheet> sheets;
  std::vector<std::string> left_over;
  double cost{};
  std::uint64_t moves{};
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("sheets", self.sheets, "The sheets that are used.");
    v.required("leftOver", self.left_over, "Ids of the pieces for which no room was found.");
    v.required("cost", self.cost, "What the used sheets cost in all; sheets without a cost cost 1 each.");
    v.required("moves", self.moves, "Number of moves of a piece in the search.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

double utilisation_of(const selvage::nesting::sheets::SheetLayout& layout) {
  const Marker& marker = layout.marker;
  double area = 0;
  for (const Piece& piece : marker.pieces) {
    const Shape& shape = marker.shapes[piece.shape.value];
    if (!piece.rules.zone) area += geometry::area_of(shape.outline);
  }
  return area / layout.area;
}

// The marker as a file; its zones and their shapes have no further fields.  The bins of the instance are left out: it
// is one of them.
MarkerFile with_sheet(const MarkerFile& file, Marker marker) {
  MarkerFile known{.marker = {}, .format = file.format, .notes = {}, .attributes = file.attributes};
  known.attributes.whole.erase("bins");
  known.marker.pieces = file.marker.pieces;
  known.marker.unplaced = file.marker.unplaced;
  for (const Piece& piece : marker.pieces) {
    if (!piece.rules.zone) continue;
    known.marker.pieces.push_back(piece);
    known.attributes.pieces.push_back(Json::object());
    known.attributes.shapes.push_back(Json::object());
  }
  return edits::with_marker(known, std::move(marker));
}

// Why the marker of a sheet could not be read again, such as for coordinates that are too large; before the search.
std::optional<Error> unreadable(const MarkerFile& file, const GivenSheet& given) {
  auto marker = selvage::nesting::sheets::bare(file.marker, given.sheet);
  if (!marker) return std::nullopt;  // which the search says
  const auto& pieces = file.marker.unplaced.empty() ? file.marker.pieces : file.marker.unplaced;
  if (pieces.empty()) return std::nullopt;
  const Piece& any = pieces.front();  // without its rules, which only this sheet may not keep
  marker->unplaced = {{.id = any.id, .shape = any.shape, .orientation = any.orientation, .at = {}}};
  const auto document = files::marker_document(with_sheet(file, *std::move(marker)), files::FileFormat::kNative);
  if (!document) return document.error();
  const auto read = formats::read_document(*document);
  if (read) return std::nullopt;
  return Error{read.error().code, "no marker can have this sheet: " + read.error().message, given.field};
}

Result<NestSheetsResult> run_nest_sheets(const NestSheetsParams& params, const MarkerFile& file,
                                         const calls::MethodContext& context) {
  const auto given = sheets_of(params.sheets, file);
  if (!given) return given.error();
  auto budget = budget_of(params.effort);
  if (!budget) return budget.error();
  auto values = values_of(params.values, file.marker);
  if (!values) return values.error();
  selvage::nesting::sheets::SheetSettings settings;
  settings.moves = budget->moves;
  settings.elapsed = std::move(budget->elapsed);
  settings.seed = params.effort.seed;
  settings.values = *std::move(values);
  std::vector<selvage::nesting::sheets::Sheet> sheets;
  for (const GivenSheet& one : *given) {
    if (auto error = unreadable(file, one)) return *std::move(error);
    sheets.push_back(one.sheet);
  }
  auto done = nest_on_sheets(file.marker, sheets, settings, context.run);
  if (!done) return with_field_of(done.error(), *given);
  NestSheetsResult result{.sheets = {},
                          .left_over = {},
                          .cost = 0,
                          .moves = done->moves,
                          .stop = cause_of_end(done->reason, done->out_of_time, context)};
  for (selvage::nesting::sheets::SheetLayout& layout : done->layouts) {
    NestedSheet nested{.sheet = layout.sheet,
                       .pieces = piece_count(layout.marker),
                       .utilisation = utilisation_of(layout),
                       .marker = {}};
    auto document = files::marker_document(with_sheet(file, std::move(layout.marker)), files::FileFormat::kNative);
    if (!document) return document.error();
    nested.marker = {*std::move(document)};
    result.cost += sheets[layout.sheet].cost;
    result.sheets.push_back(std::move(nested));
  }
  for (const Piece& piece : done->left_over) result.left_over.push_back(piece.id);
  return result;
}

}  // namespace

calls::Method nest_sheets_method() {
  return readings::reading_method("marker.nestSheets", calls::MethodKind::kSearch,
                                  "Nests all pieces on as few of the given sheets as it finds, or on those that cost "
                                  "least; the marker itself stays as it is.",
                                  run_nest_sheets);
}

}  // namespace selvage::protocol::methods::nesting
