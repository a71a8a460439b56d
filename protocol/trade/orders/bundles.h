// The bundles of a marker: for each garment of its ratio, the pieces that the garment needs.
#pragma once

#include <vector>

#include "core/base/result.h"
#include "protocol/trade/orders/order.h"
#include "protocol/trade/style_marker.h"

namespace selvage::protocol::trade::orders {

// The copies to cut, bundle by bundle: "M-B FRONT R1" is the first right front of the second garment of size M.  The
// style's pieces of other materials are left out, those that remain are enlarged by the shrinkage of their material,
// and each second bundle lies turned by 180 degrees when the order says so.
// Errors: kOutOfRange (a size that the style does not have, no piece of the material, too many pieces); `field` points
// into the order.
[[nodiscard]] Result<std::vector<PieceCopy>> bundles_of(Style& style, const Order& order);

}  // namespace selvage::protocol::trade::orders
