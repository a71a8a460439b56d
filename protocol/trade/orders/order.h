// An order, and the marker to make for it.
//
// JSON:  {"order": "A17", "style": "S350", "quantities": {"red": {"S": 10, "M": 20}},
//         "material": "SHL", "width": 1500, "mode": "either", "ratio": {"S": 1, "M": 2},
//         "shrinkage": {"SHL": {"length": 3, "width": 1.5}}}
// CSV:   colour,S,M      or with sizes in the rows, or as a list of colours, sizes and quantities (order_table.h)
//        red,10,20
// `ratio` says how many bundles of each size the marker holds; without it, they are the sums of the quantities over all
// colours, divided by their greatest common divisor.  Units: millimetres; shrinkage in per cent of the cloth's length
// and width.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "protocol/trade/style.h"

namespace selvage::protocol::trade::orders {

// How bundles may lie on cloth with a nap: each either way, all one way, or each second one turned by 180 degrees.
enum class NapMode { kOneWay, kEitherWay, kUpAndDown };
inline constexpr std::string_view kNapModeWords[] = {"one", "either", "upDown"};  // by NapMode

struct Shrinkage {
  double length{}, width{};  // per cent
};

struct Quantity {
  std::string colour, size;
  int garments{};
  friend bool operator==(const Quantity&, const Quantity&) = default;
};

struct Order {
  std::string id, style;
  std::vector<Quantity> quantities;                // in the order's own order
  std::vector<std::pair<std::string, int>> ratio;  // size, bundles; in the order's own order
  std::string material;                            // of the marker; empty: all materials
  std::optional<double> width;
  NapMode mode{NapMode::kOneWay};
  std::map<std::string, Shrinkage> shrinkage;  // by material
  std::vector<Note> notes;
};

inline constexpr int kMostBundles = 1000;  // of one size

// JSON when the text begins with {, else a table.
// Errors: those of parse and of reading fields; kSyntax and kMissingField for a CSV that is no table.  `field` is a
// JSON pointer into the order, or "/line/N".
[[nodiscard]] Result<Order> read_order(std::string_view text);

// The order with one bundle of each size that it has quantities of; a plan chooses the ratios of its markers.  Errors:
// kMissingField without quantities; kOutOfRange when each second bundle is to be turned, since no bundle is the second
// one yet.
[[nodiscard]] Result<Order> one_of_each_size(Order order);

}  // namespace selvage::protocol::trade::orders
