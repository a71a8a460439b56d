#include "protocol/trade/orders/order.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "protocol/json/fields.h"
#include "protocol/trade/orders/order_table.h"
#include "protocol/trade/orders/ratio.h"
#include "protocol/trade/text.h"
#include "protocol/trade/unicode/utf8_text.h"

namespace selvage::protocol::trade::orders {
namespace {

class OrderReader {
 public:
  explicit OrderReader(const Json& value) : value_{value} {}

  Result<Order> read() {
    json::Fields fields{value_, "", mistake_};
    order_.id = fields.text_or("order", "");
    order_.style = fields.text_or("style", "");
    order_.material = fields.text_or("material", "");
    order_.width = fields.maybe_number("width", {1, 1e6});
    order_.mode = static_cast<NapMode>(fields.word_or("mode", 0, kNapModeWords));
    if (const Json* ratio = fields.maybe_object("ratio")) {
      for (const auto& [size, bundles] : ratio->items()) {
        const int count = whole(bundles, kMostBundles, fields.pointer("ratio") + "/" + size);
        if (count > 0) order_.ratio.emplace_back(size, count);
      }
    }
    Sums sums;
    if (const Json* quantities = fields.maybe_object("quantities")) read_quantities(*quantities, sums);
    if (const Json* shrinkage = fields.maybe_object("shrinkage")) read_shrinkage(*shrinkage);
    fields.finish();
    if (order_.ratio.empty() && sums.all().empty()) {
      mistake_.add(ErrorCode::kMissingField, "neither a ratio nor quantities: what is to be cut?", "/ratio");
    }
    if (mistake_) return mistake_.error();
    settle_ratio(order_, sums);
    return std::move(order_);
  }

 private:
  int whole(const Json& value, double most, const std::string& at) {
    const double number = checked_number(value, {0, most}, mistake_, at);
    if (number != std::floor(number)) {
      mistake_.add(ErrorCode::kOutOfRange, json::number_text(number) + " where a whole number is required", at);
    }
    return mistake_ ? 0 : static_cast<int>(number);
  }

  void read_quantities(const Json& quantities, Sums& sums) {
    for (const auto& [colour, sizes] : quantities.items()) {
      const std::string at = "/quantities/" + colour;
      if (!sizes.is_object()) {
        mistake_.add(ErrorCode::kWrongType, json::shortened(sizes) + " where sizes and garments are required", at);
        return;
      }
      for (const auto& [size, garments] : sizes.items()) {
        std::string field = at;
        field += '/';
        field += size;
        order_.quantities.push_back({colour, size, whole(garments, kMostGarments, field)});
        sums.add(size, order_.quantities.back().garments);
      }
    }
  }

  void read_shrinkage(const Json& shrinkage) {
    for (const auto& [material, value] : shrinkage.items()) {
      json::Fields fields{value, "/shrinkage/" + material, mistake_};
      Shrinkage& one = order_.shrinkage[material];
      one.length = fields.number_or("length", 0, {-50, 50});
      one.width = fields.number_or("width", 0, {-50, 50});
      fields.finish();
    }
  }

  const Json& value_;
  json::Mistake mistake_;
  Order order_;
};

Result<Order> read_utf8(std::string_view text) {
  if (trimmed(text).empty()) return Error{ErrorCode::kMissingField, "the order is empty", ""};
  if (!trimmed(text.substr(0, 4096)).starts_with('{')) return read_order_table(text);
  const auto document = json::parse(text);
  if (!document) return document.error();
  return OrderReader{*document}.read();
}

}  // namespace

Result<Order> read_order(std::string_view text) {
  const auto utf8 = unicode::Utf8Text::of(text);
  if (!utf8) return utf8.error();
  auto order = read_utf8(utf8->text());
  if (order && !utf8->encoding().empty()) {
    order->notes.push_back({"", "the order is read as " + std::string{utf8->encoding()}});
  }
  return order;
}

Result<Order> one_of_each_size(Order order) {
  if (order.quantities.empty()) {
    return Error{ErrorCode::kMissingField, "the order has no quantities: how many garments are to be cut?",
                 "/quantities"};
  }
  if (order.mode == NapMode::kUpAndDown) {
    return Error{ErrorCode::kOutOfRange, "upDown turns every second bundle; in a plan, one or either is allowed",
                 "/mode"};
  }
  std::erase_if(order.notes,
                [](const Note& note) { return note.text.starts_with(kNoRatio) || note.text.starts_with(kLeftOut); });
  order.ratio.clear();
  for (const Quantity& quantity : order.quantities) {
    const bool known = std::any_of(order.ratio.begin(), order.ratio.end(),
                                   [&](const auto& bundles) { return bundles.first == quantity.size; });
    if (!known) order.ratio.emplace_back(quantity.size, 1);
  }
  return order;
}

}  // namespace selvage::protocol::trade::orders
