#include "core/nesting/layout/dice.h"

namespace selvage::nesting::layout {

double Dice::unit() {
  constexpr int kDropped = 11;  // 53 bits are left, as many as a double holds
  return static_cast<double>(random_() >> kDropped) * 0x1p-53;
}

std::size_t Dice::below(std::size_t number) {
  return static_cast<std::size_t>(unit() * static_cast<double>(number));
}

}  // namespace selvage::nesting::layout
