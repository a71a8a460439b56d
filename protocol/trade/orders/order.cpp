#include "protocol/trade/orders/order.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numeric>

#include "protocol/json/fields.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::orders {
namespace {

constexpr double kMostGarments = 1e6;

using Sums = std::vector<std::pair<std::string, int>>;

void add_to(Sums& sums, const std::string& size, int garments) {
  const auto known = std::find_if(sums.begin(), sums.end(), [&](const auto& sum) { return sum.first == size; });
  if (known == sums.end())
    sums.emplace_back(size, garments);
  else
    known->second += garments;
}

// The ratio that divides the order into whole markers, if the order gives none.
void settle_ratio(Order& order, const Sums& sums) {
  if (!order.ratio.empty()) return;
  int divisor = 0;
  for (const auto& [size, garments] : sums) divisor = std::gcd(divisor, garments);
  std::string shown;
  for (const auto& [size, garments] : sums) {
    if (garments == 0) continue;
    order.ratio.emplace_back(size, garments / divisor);
    shown += (shown.empty() ? "" : ", ") + size + ": " + std::to_string(garments / divisor);
  }
  order.notes.push_back(
      {"", "the order gives no ratio: " + shown + ", of which " + std::to_string(divisor) + " plies are needed"});
}

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
    if (order_.ratio.empty() && sums.empty()) {
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
        add_to(sums, size, order_.quantities.back().garments);
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

std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells;
  while (true) {
    const std::size_t end = std::min(line.find(separator), line.size());
    std::string_view cell = trimmed(line.substr(0, end));
    if (cell.size() > 1 && cell.starts_with('"') && cell.ends_with('"')) cell = cell.substr(1, cell.size() - 2);
    cells.push_back(printable(cell));
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

Result<Order> read_table(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Lines lines{text};
  const auto heading = lines.next();
  const char separator = heading && heading->find(';') != std::string_view::npos ? ';' : ',';
  const auto sizes = heading ? cells_of(*heading, separator) : std::vector<std::string>{};
  if (sizes.size() < 2) {
    return Error{ErrorCode::kMissingField, "the order's first line must name the sizes: colour,S,M,L", line_field(1)};
  }
  Order order;
  Sums sums;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const auto cells = cells_of(*line, separator);
    if (cells.size() > sizes.size()) {
      return error_at(lines.number(), ErrorCode::kSyntax, "more cells than the heading has");
    }
    for (std::size_t k = 1; k < cells.size(); ++k) {
      int garments = 0;
      const char* end = cells[k].data() + cells[k].size();
      const bool whole = cells[k].empty() || std::from_chars(cells[k].data(), end, garments).ptr == end;
      if (!whole || garments < 0 || garments > kMostGarments) {
        return error_at(lines.number(), ErrorCode::kSyntax,
                        json::shortened(Json(cells[k])) + " where a number of garments is required");
      }
      if (!cells[k].empty()) order.quantities.push_back({cells[0], sizes[k], garments});
      add_to(sums, sizes[k], garments);
    }
  }
  if (std::all_of(sums.begin(), sums.end(), [](const auto& sum) { return sum.second == 0; })) {
    return Error{ErrorCode::kMissingField, "the order has no garments", ""};
  }
  settle_ratio(order, sums);
  return order;
}

}  // namespace

Result<Order> read_order(std::string_view text) {
  if (!trimmed(text.substr(0, 4096)).starts_with('{')) return read_table(text);
  const auto document = json::parse(text);
  if (!document) return document.error();
  return OrderReader{*document}.read();
}

Result<Order> one_of_each_size(Order order) {
  if (order.quantities.empty()) {
    return Error{ErrorCode::kMissingField, "the order has no quantities: how many garments are to be cut?",
                 "/quantities"};
  }
  if (order.mode == NapMode::kUpAndDown) {
    return Error{ErrorCode::kOutOfRange, "upDown, by which every second bundle is turned; a plan takes one or either",
                 "/mode"};
  }
  order.notes.clear();  // they concern the ratio
  order.ratio.clear();
  for (const Quantity& quantity : order.quantities) {
    const bool known = std::any_of(order.ratio.begin(), order.ratio.end(),
                                   [&](const auto& bundles) { return bundles.first == quantity.size; });
    if (!known) order.ratio.emplace_back(quantity.size, 1);
  }
  return order;
}

}  // namespace selvage::protocol::trade::orders
