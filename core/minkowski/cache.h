// The cache of Minkowski sums: one entry per pair of outlines and relative orientation, shared by every marker and every
// thread, bounded in bytes, counted.  What it returns does not depend on what it holds.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace selvage {

struct CacheCounts {
  std::uint64_t hits{}, misses{};
  std::size_t entries{}, bytes{}, limit{};
};

class SumCache {
 public:
  explicit SumCache(std::size_t limit_bytes = std::size_t{256} << 20);
  ~SumCache();
  SumCache(const SumCache&) = delete;
  SumCache& operator=(const SumCache&) = delete;

  [[nodiscard]] CacheCounts counts() const;

 private:
  struct Store;
  std::unique_ptr<Store> store_;
};

}  // namespace selvage
