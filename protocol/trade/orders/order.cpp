#include "protocol/trade/orders/order.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

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

// The cells of a line; in quotes, separators count as text and "" is a quote.
std::vector<std::string> cells_of(std::string_view line, char separator) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (c == '"' && quoted && line.substr(at + 1, 1) == "\"") {
      cells.back() += line[at++];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == separator && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = std::string{trimmed(cell)};
  return cells;
}

// A number of garments as spreadsheets write it: 1200, 1,200, 1.200, 1 200, 1'200 or 1200.00; an empty cell is none.
std::optional<int> garments_in(std::string cell) {
  if (cell.empty()) return 0;
  const std::size_t mark = cell.find_first_of(",.' ");
  if (mark != std::string::npos && mark <= 3) {
    const char grouping = cell[mark];
    bool groups = true;  // of three digits after every mark
    for (std::size_t at = mark; at < cell.size(); at += 4)
      groups = groups && cell[at] == grouping && at + 4 <= cell.size();
    if (groups) std::erase(cell, grouping);
  }
  const auto number = number_in(cell);
  if (!number || *number != std::floor(*number) || *number < 0 || *number > kMostGarments) return std::nullopt;
  return static_cast<int>(*number);
}

class TableReader {
 public:
  explicit TableReader(std::string_view text) : lines_{text}, encoding_{encoding_of(text)} {}

  Result<Order> read() {
    auto heading = lines_.next();
    const auto is_heading = [](std::string_view line) {  // not blank, nor the "sep=;" of spreadsheets
      return !trimmed(line).empty() && !in_capitals(trimmed(line)).starts_with("SEP=");
    };
    while (heading && !is_heading(*heading)) heading = lines_.next();
    for (const char separator : {',', '\t', ';'}) {
      if (heading && heading->find(separator) != std::string_view::npos) separator_ = separator;
    }
    if (heading) sizes_ = row(*heading);
    while (sizes_.size() > 1 && (sizes_.back().empty() || is_sum(sizes_.back()))) {
      if (!sizes_.back().empty()) {
        order_.notes.push_back(
            {line_field(lines_.number()), "the column " + json::shortened(Json(sizes_.back())) + " is left out"});
      }
      sizes_.pop_back();
      ++unread_columns_;
    }
    if (sizes_.size() < 2) {
      return Error{ErrorCode::kMissingField, "the order's first line must name the sizes: colour,S,M,L",
                   line_field(std::max<std::size_t>(lines_.number(), 1))};
    }
    while (const auto line = lines_.next()) {
      if (trimmed(*line).empty()) continue;
      if (const auto error = read_row(row(*line))) return *error;
    }
    if (std::all_of(sums_.begin(), sums_.end(), [](const auto& sum) { return sum.second == 0; })) {
      return Error{ErrorCode::kMissingField, "the order has no garments", ""};
    }
    settle_ratio(order_, sums_);
    return std::move(order_);
  }

 private:
  std::vector<std::string> row(std::string_view line) const {
    auto cells = cells_of(line, separator_);
    for (std::string& cell : cells) cell = decoded(cell, encoding_);
    return cells;
  }

  // A row or column of sums, as spreadsheets have them.
  static bool is_sum(const std::string& name) {
    const std::string capitals = in_capitals(name);
    return capitals == "TOTAL" || capitals == "TOTALS" || capitals == "SUM";
  }

  std::optional<Error> read_row(const std::vector<std::string>& cells) {
    const auto filled =
        std::find_if(cells.rbegin(), cells.rend(), [](const std::string& cell) { return !cell.empty(); });
    const auto count = static_cast<std::size_t>(cells.rend() - filled);
    if (count > sizes_.size() + unread_columns_) {
      return error_at(lines_.number(), ErrorCode::kSyntax,
                      std::to_string(count) + " cells; the heading has " + std::to_string(sizes_.size()));
    }
    if (is_sum(cells[0])) {
      order_.notes.push_back({line_field(lines_.number()),
                              json::shortened(Json(cells[0])) + " is taken as the sum of the rows; left out"});
      return std::nullopt;
    }
    for (std::size_t k = 1; k < std::min(cells.size(), sizes_.size()); ++k) {
      const auto garments = garments_in(cells[k]);
      if (!garments) {
        return error_at(lines_.number(), ErrorCode::kSyntax,
                        json::shortened(Json(cells[k])) + " where a number of garments is required, from 0 to 1000000");
      }
      if (!cells[k].empty()) order_.quantities.push_back({cells[0], sizes_[k], *garments});
      add_to(sums_, sizes_[k], *garments);
    }
    return std::nullopt;
  }

  Lines lines_;
  Encoding encoding_;
  char separator_{','};
  std::vector<std::string> sizes_;  // the heading: the first is that of the colours
  std::size_t unread_columns_{};    // behind the sizes: sums, or empty
  Order order_;
  Sums sums_;
};

}  // namespace

Result<Order> read_order(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (!trimmed(text.substr(0, 4096)).starts_with('{')) return TableReader{text}.read();
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
    return Error{ErrorCode::kOutOfRange, "upDown turns every second bundle; in a plan, one or either is allowed",
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
