// Values of parameters and results other than numbers and plain strings: points, directions, ids, tokens and
// documents.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

#include "core/base/result.h"
#include "protocol/formats/decimal_marker.h"
#include "protocol/schema/wire.h"

namespace selvage::protocol::calls {

using schema::Id;

// [x, y] in the marker's unit.
using Point = formats::Decimal;
[[nodiscard]] Point point_of(Vec at, Resolution resolution);              // exact
[[nodiscard]] Point point_of(double x, double y, Resolution resolution);  // fractional lattice units
// The nearest lattice point.  Errors: kOutOfRange when it is beyond the lattice; `field` names the parameter.
[[nodiscard]] Result<Vec> place_on_lattice(const Point& place, Resolution resolution, std::string_view field);

// [x, y]: a direction or a force, never (0, 0).
struct Direction {
  double x{}, y{};
};
inline constexpr double kLargestForce = 1e9, kLeastForce = 1e-9;  // limits of absolute values: of each; of the larger

// A number or a short string that the client chose.
struct ProgressToken {
  Json value;
};
inline constexpr std::size_t kLongestToken = 128;  // bytes

// The id of a JSON-RPC call: a number, a string or null.
struct CallId {
  Json value;
};

// An arbitrary JSON object in parameters.  Valid only as long as the parameters are.
struct DocumentView {
  const Json* value{};
};
// A document in a result: an object, or a string for svg.
struct Document {
  Json value;
};

// The piece of the marker with this id.  Errors: kOutOfRange; `field` is the parameter that names the piece.
[[nodiscard]] Result<PieceId> piece_of(const Marker& marker, const std::string& id, const std::string& field);

// The same for lists of ids: looks through the marker once.  The marker must outlive this.
class PiecesById {
 public:
  explicit PiecesById(const Marker& marker);
  [[nodiscard]] Result<PieceId> piece_of(const std::string& id, const std::string& field) const;

 private:
  std::unordered_map<std::string_view, PieceId> pieces_;
};

}  // namespace selvage::protocol::calls

namespace selvage::protocol::schema {

template <>
struct Wire<calls::Direction> {
  static Type type();
  static Json write(const calls::Direction& value) { return Json::array({value.x, value.y}); }
  static void read(const FieldAt& at, calls::Direction& value);
};

template <>
struct Wire<calls::ProgressToken> {
  static Type type();
  static Json write(const calls::ProgressToken& value) { return value.value; }
  static void read(const FieldAt& at, calls::ProgressToken& value);
};

template <>
struct Wire<calls::CallId> {
  static Type type() { return either({{Type::Kind::kNumber}, {Type::Kind::kString}, {Type::Kind::kNull}}); }
  static Json write(const calls::CallId& value) { return value.value; }
  static void read(const FieldAt& at, calls::CallId& value) {
    if (const Json* id = at.fields.required_any(at.key)) value.value = *id;
  }
};

template <>
struct Wire<calls::DocumentView> {
  static Type type() { return {Type::Kind::kObject}; }
  static Json write(const calls::DocumentView& value) { return value.value ? *value.value : Json{}; }
  static void read(const FieldAt& at, calls::DocumentView& value) { value.value = &at.fields.object(at.key); }
};

template <>
struct Wire<calls::Document> {
  static Type type() { return either({{Type::Kind::kObject}, {Type::Kind::kString}}); }
  static Json write(const calls::Document& value) { return value.value; }
};

}  // namespace selvage::protocol::schema
