#include "protocol/trade/orders/bundles.h"

#include <algorithm>
#include <set>
#include <string>

#include "protocol/json/json_text.h"

namespace selvage::protocol::trade::orders {
namespace {

// A to Z, then AA to ZZ and so on.
std::string letter_of(int number) {
  std::string letters;
  for (int rest = number; rest >= 0; rest = rest / 26 - 1)
    letters.insert(letters.begin(), static_cast<char>('A' + rest % 26));
  return letters;
}

// Cloth that shrinks by s per cent must be cut 1 / (1 - s / 100) times as large.
void enlarge(PatternPiece& piece, const Shrinkage& shrinkage) {
  const double x = 1 / (1 - shrinkage.length / 100), y = 1 / (1 - shrinkage.width / 100);
  const auto scale = [x, y](Spot& spot) { spot = rounded(Spot{spot.x * x, spot.y * y}); };
  for (Spot& point : piece.outline) scale(point);
  for (document::Notch& notch : piece.annotations.notches) scale(notch.at);
  for (Spot& drill : piece.annotations.drills) scale(drill);
  for (document::DrawnText& text : piece.annotations.texts) scale(text.at);
  for (document::DrawnLine& line : piece.annotations.lines) {
    for (Spot& point : line.points) scale(point);
  }
}

Error unknown_size(const Style& style, const std::string& size) {
  std::string known;
  for (const std::string& one : style.sizes) known += (known.empty() ? "" : ", ") + one;
  return {ErrorCode::kOutOfRange,
          "size " + json::shortened(Json(size)) + " is not in the style; its sizes are " + known, "/ratio/" + size};
}

class Bundler {
 public:
  Bundler(Style& style, const Order& order) : style_{style}, order_{order} {}

  Result<std::vector<PieceCopy>> make() {
    std::set<std::string> materials;
    for (const PatternPiece& piece : style_.pieces) materials.insert(piece.material);
    keep_material();
    if (style_.pieces.empty()) {
      return unknown_material(materials);
    }
    settle_nap();
    int bundles = 0;
    for (const auto& [size, count] : order_.ratio) {
      for (int number = 0; number < count; ++number) {
        const bool turned = order_.mode == NapMode::kUpAndDown && bundles++ % 2 == 1;
        if (!add_bundle(size, size + "-" + letter_of(number), turned)) return unknown_size(style_, size);
        if (copies_.size() > marker::kMaxPieces) {
          return Error{ErrorCode::kOutOfRange,
                       "the ratio makes more than " + std::to_string(marker::kMaxPieces) + " pieces", "/ratio"};
        }
      }
    }
    return std::move(copies_);
  }

 private:
  [[nodiscard]] Error unknown_material(const std::set<std::string>& materials) const {
    std::string known;
    for (const std::string& one : materials) known += (known.empty() ? "" : ", ") + json::shortened(Json(one));
    return {ErrorCode::kOutOfRange,
            "no piece of the style is of material " + json::shortened(Json(order_.material)) + "; its materials are " +
                known,
            "/material"};
  }

  void keep_material() {
    if (!order_.material.empty()) {
      std::erase_if(style_.pieces, [&](const PatternPiece& piece) { return piece.material != order_.material; });
    }
    for (PatternPiece& piece : style_.pieces) {
      const auto shrinkage = order_.shrinkage.find(piece.material);
      if (shrinkage != order_.shrinkage.end()) enlarge(piece, shrinkage->second);
    }
  }

  // If every second bundle is rotated, each piece exists twice: as drawn, and for the rotated bundles.
  void settle_nap() {
    first_turned_ = style_.pieces.size();
    for (PatternPiece& piece : style_.pieces) {
      piece.rotations = order_.mode == NapMode::kEitherWay ? std::vector<double>{0, 180} : std::vector<double>{0};
    }
    if (order_.mode != NapMode::kUpAndDown) return;
    for (std::size_t k = 0; k < first_turned_; ++k) {
      PatternPiece turned = style_.pieces[k];
      turned.rotations = {180};
      turned.name += " (down)";
      style_.pieces.push_back(std::move(turned));
    }
  }

  bool add_bundle(const std::string& size, const std::string& bundle, bool turned) {
    bool found = false;
    for (std::size_t k = 0; k < first_turned_; ++k) {
      const PatternPiece& piece = style_.pieces[k];
      if (piece.size != size) continue;
      found = true;
      const int all = piece.quantity.right + piece.quantity.left;
      for (int copy = 0; copy < all; ++copy) {
        const bool left = copy >= piece.quantity.right;
        const int number = left ? copy - piece.quantity.right + 1 : copy + 1;
        PieceCopy one{turned ? k + first_turned_ : k, left, bundle + " " + piece.name, Json::object()};
        if (piece.quantity.left > 0)
          one.id += (left ? " L" : " R") + std::to_string(number);
        else if (all > 1)
          one.id += " " + std::to_string(number);
        one.attributes["bundle"] = bundle;
        one.attributes["size"] = size;
        if (piece.quantity.left > 0) one.attributes["side"] = left ? "left" : "right";
        copies_.push_back(std::move(one));
      }
    }
    return found;
  }

  Style& style_;
  const Order& order_;
  std::size_t first_turned_{};
  std::vector<PieceCopy> copies_;
};

}  // namespace

Result<std::vector<PieceCopy>> bundles_of(Style& style, const Order& order) {
  return Bundler{style, order}.make();
}

}  // namespace selvage::protocol::trade::orders
