#include "core/base/crew.h"

namespace selvage {
namespace {

class LoneHand final : public Crew {
 public:
  [[nodiscard]] std::size_t hands() const override { return 1; }
  void each(std::size_t count, const Part& part) const override {
    for (std::size_t k = 0; k < count; ++k) part(k);
  }
};

}  // namespace

const Crew& alone() {
  static const LoneHand lone_hand;
  return lone_hand;
}

}  // namespace selvage
