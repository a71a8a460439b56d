// marker.nestSheets: nests all pieces of a marker on sheets of given sizes and forms.
#include <string>
#include <utility>
#include <vector>

#include "core/nesting/sheets/nest_on_sheets.h"
#include "protocol/edits/changes.h"
#include "protocol/files/writing.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/methods/motions/nest_params.h"
#include "protocol/methods/readings/reading.h"
#include "protocol/schema/documents.h"

namespace selvage::protocol::methods::motions {

// The corners of a polygon in parameters.
struct SheetOutline {
  std::vector<calls::Point> corners;
};

}  // namespace selvage::protocol::methods::motions

namespace selvage::protocol::schema {

template <>
struct Wire<methods::motions::SheetOutline> {
  static Type type() { return list_of(Wire<calls::Point>::type()); }
  static Json write(const methods::motions::SheetOutline& value) {
    Json corners = Json::array();
    for (const calls::Point& corner : value.corners) corners.push_back(Wire<calls::Point>::write(corner));
    return corners;
  }
  static void read(const FieldAt& at, methods::motions::SheetOutline& value) {
    value.corners = formats::read_points(at.fields.array(at.key), at.pointer(), at.mistake);
  }
  static methods::motions::SheetOutline read_entry(const Json& value, const std::string& at, json::Mistake& mistake) {
    if (value.is_array()) return {formats::read_points(value, at, mistake)};
    mistake.add(ErrorCode::kWrongType, "is not a list; a list of corners [x, y] is allowed", at);
    return {};
  }
};

}  // namespace selvage::protocol::schema

namespace selvage::protocol::methods::motions {
namespace {

constexpr std::size_t kMostSheets = 100, kMostHoles = 200;
constexpr double kMostOfOneKind = 1'000;

struct SheetParams {
  static constexpr std::string_view kName = "Sheet";
  static constexpr std::string_view kMeaning = "Sheets of one size and form: a rectangle, or the inside of an outline.";
  std::optional<double> width, length;
  std::optional<SheetOutline> outline;
  std::optional<std::vector<SheetOutline>> holes;
  std::uint64_t count{1};

  static void describe(auto& v, auto& self) {
    v.optional("width", self.width, "The width of a rectangle, across the grain, in the marker's unit.",
               {.range = formats::kStripWidths});
    v.optional("length", self.length, "The length of a rectangle, along the grain.", {.range = formats::kStripWidths});
    v.optional("outline", self.outline, "The corners [x, y] of the sheet, instead of a width and a length.");
    v.optional("holes", self.holes, "Outlines of holes and faults that no piece may cover.",
               {.entries = {{0, kMostHoles}}, .entries_are = "holes"});
    v.optional("count", self.count, "How many of these sheets there are, 1 to 1,000.",
               {.range = {{1, kMostOfOneKind}}});
  }
};

struct NestSheetsParams {
  std::string marker_id;
  std::vector<SheetParams> sheets;
  NestEffort effort;
  std::optional<std::vector<PieceValue>> values;
  std::optional<double> deadline_ms;

  static void describe(auto& v, auto& self) {
    v.required("markerId", self.marker_id, calls::kMarkerIdMeaning);
    v.required("sheets", self.sheets, "The kinds of sheets that there are, 1 to 100.",
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
    v.required("sheet", self.sheet, "Index of its kind in the parameter.");
    v.required("pieces", self.pieces, "Number of pieces on it.");
    v.required("utilisation", self.utilisation, "The pieces' area divided by that of the sheet, 0 to 1.");
    v.required("marker", self.marker,
               "A native document: the strip is the sheet or, with an outline, its bounding box; positions are "
               "measured from its lower left corner.");
  }
};

struct NestSheetsResult {
  std::vector<NestedSheet> sheets;
  std::vector<std::string> left_over;
  std::uint64_t moves{};
  calls::StopCause stop{};

  static void describe(auto& v, auto& self) {
    v.required("sheets", self.sheets, "The sheets that are used.");
    v.required("leftOver", self.left_over, "Ids of the pieces for which there is no room.");
    v.required("moves", self.moves, "Number of moves of a piece in the search.");
    v.required("stop", self.stop, calls::kStopMeaning);
  }
};

Result<Polygon> polygon_of(const SheetOutline& outline, Resolution resolution, const std::string& field) {
  Polygon corners;
  for (const calls::Point& corner : outline.corners) {
    const auto at = calls::place_on_lattice(corner, resolution, field + "/" + std::to_string(corners.size()));
    if (!at) return at.error();
    corners.push_back(*at);
  }
  auto clean = geometry::clean_polygon(corners);
  if (clean) return std::move(clean->polygon);
  return Error{ErrorCode::kOutOfRange, "is not a simple polygon: " + clean.error().message, field};
}

Result<nesting::sheets::Sheet> sheet_of(const SheetParams& params, Resolution resolution, const std::string& field) {
  std::vector<Polygon> holes;
  for (const SheetOutline& outline : params.holes.value_or(std::vector<SheetOutline>{})) {
    auto hole = polygon_of(outline, resolution, field + "/holes/" + std::to_string(holes.size()));
    if (!hole) return hole.error();
    holes.push_back(*std::move(hole));
  }
  nesting::sheets::Sheet sheet;
  if (params.outline) {
    if (params.width || params.length) {
      return Error{ErrorCode::kOutOfRange,
                   "is given together with a width or a length; a sheet has either an outline or both of these",
                   field + "/outline"};
    }
    auto outline = polygon_of(*params.outline, resolution, field + "/outline");
    if (!outline) return outline.error();
    sheet = nesting::sheets::sheet_within(*outline, std::move(holes));
  } else {
    if (!params.width || !params.length) {
      return Error{ErrorCode::kMissingField, "is missing; a sheet has a width and a length, or an outline",
                   field + (params.width ? "/length" : "/width")};
    }
    const auto corner = calls::place_on_lattice({*params.length, *params.width}, resolution, field);
    if (!corner) return corner.error();
    sheet.width = formats::overlap_on_lattice(*params.width, resolution);  // both rounded down
    sheet.length = formats::overlap_on_lattice(*params.length, resolution);
    sheet.holes = std::move(holes);
  }
  sheet.count = params.count;
  return sheet;
}

double utilisation_on(const nesting::sheets::Sheet& sheet, const Marker& marker) {
  double area = 0;
  for (const Piece& piece : marker.pieces) {
    area += static_cast<double>(doubled_area(marker.shapes[piece.shape.value].outline)) / 2;
  }
  return area / area_of(sheet);
}

Result<NestSheetsResult> run_nest_sheets(const NestSheetsParams& params, const MarkerFile& file,
                                         const calls::MethodContext& context) {
  std::vector<nesting::sheets::Sheet> sheets;
  for (const SheetParams& given : params.sheets) {
    auto sheet = sheet_of(given, file.marker.resolution, "/sheets/" + std::to_string(sheets.size()));
    if (!sheet) return sheet.error();
    sheets.push_back(*std::move(sheet));
  }
  auto budget = budget_of(params.effort);
  if (!budget) return budget.error();
  auto values = values_of(params.values, file.marker);
  if (!values) return values.error();
  nesting::sheets::SheetSettings settings;
  settings.moves = budget->moves;
  settings.elapsed = std::move(budget->elapsed);
  settings.seed = params.effort.seed;
  settings.values = *std::move(values);
  auto done = nest_on_sheets(file.marker, sheets, settings, context.run);
  if (!done) return done.error();

  NestSheetsResult result{.sheets = {},
                          .left_over = {},
                          .moves = done->moves,
                          .stop = cause_of_end(done->reason, done->out_of_time, context)};
  for (nesting::sheets::SheetLayout& layout : done->layouts) {
    NestedSheet nested{.sheet = layout.sheet,
                       .pieces = layout.marker.pieces.size(),
                       .utilisation = utilisation_on(sheets[layout.sheet], layout.marker),
                       .marker = {}};
    auto document =
        files::marker_document(edits::with_marker(file, std::move(layout.marker)), files::FileFormat::kNative);
    if (!document) return document.error();
    nested.marker = {*std::move(document)};
    result.sheets.push_back(std::move(nested));
  }
  for (const Piece& piece : done->left_over) result.left_over.push_back(piece.id);
  return result;
}

}  // namespace

calls::Method nest_sheets_method() {
  return readings::reading_method("marker.nestSheets", calls::MethodKind::kSearch,
                                  "Nests all pieces on as few of the given sheets as it finds; the marker itself stays "
                                  "as it is.",
                                  run_nest_sheets);
}

}  // namespace selvage::protocol::methods::motions
