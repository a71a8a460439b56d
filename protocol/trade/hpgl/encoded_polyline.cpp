#include "protocol/trade/hpgl/encoded_polyline.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>

namespace selvage::protocol::trade::hpgl {
namespace {

constexpr unsigned kFirstDigit = 63;
constexpr double kFarthest = 1e9;

class Decoder {
 public:
  explicit Decoder(std::string_view text) : text_{text} {}

  EncodedPolyline decode() {
    bool up = false, absolute = false;
    while (const auto code = next()) {
      if (*code == '7') {
        seven_bits_ = true;
      } else if (*code == ':') {
        damage_unless(number().has_value());  // the pen's number
      } else if (*code == '<') {
        up = true;
      } else if (*code == '>') {
        set_fraction(number());
      } else if (*code == '=') {
        absolute = true;
      } else if (is_digit(*code)) {
        --at_;
        const auto x = number(), y = number();
        damage_unless(x && y);
        if (x && y) read_.moves.push_back({{coordinate(*x), coordinate(*y)}, up, absolute});
        up = absolute = false;
      } else {
        damage_unless(false);
      }
    }
    return std::move(read_);
  }

 private:
  // The next byte that means something; blanks and control characters do not.
  std::optional<unsigned> next() {
    constexpr unsigned kDelete = 127, kFirstHigh = 161, kLast = 255, kLowBits = 0x7f;
    while (at_ < text_.size()) {
      unsigned code = static_cast<unsigned char>(text_[at_++]);
      if (seven_bits_) code &= kLowBits;
      if (code > ' ' && code != kDelete && (code < kDelete || (code >= kFirstHigh && code < kLast))) return code;
    }
    return std::nullopt;
  }

  // The lowest code of a digit that ends its number; the codes of the other digits begin at kFirstDigit.
  [[nodiscard]] unsigned first_last_digit() const { return seven_bits_ ? 95 : 191; }
  [[nodiscard]] bool is_digit(unsigned code) const {
    const unsigned base = seven_bits_ ? 32 : 64;
    return (code >= kFirstDigit && code < kFirstDigit + base) ||
           (code >= first_last_digit() && code < first_last_digit() + base);
  }

  // Digits from the least, of base 64, or of base 32 with seven bits; the last one is marked.  Its lowest bit is the
  // sign.
  std::optional<std::int64_t> number() {
    constexpr unsigned kMostBits = 48;
    const unsigned base_bits = seven_bits_ ? 5 : 6;
    std::int64_t value = 0;
    for (unsigned shift = 0; shift <= kMostBits; shift += base_bits) {
      const auto code = next();
      if (!code) return std::nullopt;
      if (!is_digit(*code)) {
        --at_;  // a flag: the number was cut off
        return std::nullopt;
      }
      const unsigned first_last = first_last_digit();
      const bool last = *code >= first_last;
      value += static_cast<std::int64_t>(*code - (last ? first_last : kFirstDigit)) << shift;
      if (last) return value % 2 == 1 ? -(value / 2) : value / 2;
    }
    return std::nullopt;
  }

  void set_fraction(std::optional<std::int64_t> bits) {
    constexpr std::int64_t kMost = 26;
    damage_unless(bits && std::abs(*bits) <= kMost);
    if (bits && std::abs(*bits) <= kMost) unit_ = std::ldexp(1, -static_cast<int>(*bits));
  }

  [[nodiscard]] double coordinate(std::int64_t number) const {
    return std::clamp(static_cast<double>(number) * unit_, -kFarthest, kFarthest);
  }
  void damage_unless(bool sound) { read_.damaged = read_.damaged || !sound; }

  std::string_view text_;
  std::size_t at_{};
  bool seven_bits_{};
  double unit_{1};  // of a coordinate's last digit
  EncodedPolyline read_;
};

}  // namespace

EncodedPolyline decode_polyline(std::string_view text) {
  return Decoder{text}.decode();
}

}  // namespace selvage::protocol::trade::hpgl
