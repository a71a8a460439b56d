#include "core/base/executor.h"

namespace selvage {
namespace {

class SerialExecutor final : public Executor {
 public:
  [[nodiscard]] std::size_t parallelism() const override { return 1; }
  void for_each(std::size_t count, const Part& part) const override {
    for (std::size_t k = 0; k < count; ++k) part(k);
  }
};

}  // namespace

const Executor& serial() {
  static const SerialExecutor executor;
  return executor;
}

}  // namespace selvage
