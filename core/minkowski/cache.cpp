#include "core/minkowski/cache.h"

#include <list>
#include <map>
#include <mutex>
#include <unordered_map>

#include "core/geometry/outward.h"

namespace selvage {
namespace {

// Relative orientation and the outlines themselves: equal keys have equal sums.
struct Key {
  std::shared_ptr<const Outline> p, q;
  Symmetry relative;

  friend bool operator==(const Key& a, const Key& b) {
    const auto same = [](const auto& x, const auto& y) {
      return x == y || (x->hash == y->hash && x->polygon == y->polygon);
    };
    return a.relative == b.relative && same(a.p, b.p) && same(a.q, b.q);
  }
};
struct KeyHash {
  std::size_t operator()(const Key& key) const {
    return key.p->hash * 0x9e3779b97f4a7c15U ^ (key.q->hash + static_cast<std::size_t>(key.relative.index()));
  }
};

// True when the pair (p, q) is kept as (q, p): so that both orders share one entry.
bool kept_swapped(const OrientedOutline& p, const OrientedOutline& q) {
  const Outline& a = *p.outline;
  const Outline& b = *q.outline;
  if (a.hash != b.hash) return a.hash > b.hash;
  if (a.polygon != b.polygon) return a.polygon > b.polygon;
  const Symmetry forth = p.symmetry.inverse().after(q.symmetry);
  return forth.inverse().index() < forth.index();
}

// Under which key the sum of a pair is kept, and how the pair sees it.
struct Kept {
  Key key;
  Symmetry frame;
  bool swapped{};
};
Kept kept_as(const OrientedOutline& p, const OrientedOutline& q) {
  const bool swapped = kept_swapped(p, q);
  const OrientedOutline& first = swapped ? q : p;
  const OrientedOutline& second = swapped ? p : q;
  return {{first.outline, second.outline, first.symmetry.inverse().after(second.symmetry)}, first.symmetry, swapped};
}

using Sum = std::shared_ptr<const MinkowskiSum>;
Sum make(const Key& key) {
  return std::make_shared<const MinkowskiSum>(obstacle_sum(*key.p, *key.q, key.relative));
}

constexpr std::size_t kBlock = 4;  // sums that one hand makes in a row

}  // namespace

struct SumCache::Store {
  struct Entry {
    Key key;
    Sum sum;
    std::size_t bytes{};
  };
  using Entries = std::list<Entry>;  // most recently used first

  std::size_t limit{};
  static constexpr std::size_t kOutlines = 100'000;  // all are forgotten when there are more

  mutable std::mutex mutex;
  std::unordered_multimap<std::uint64_t, std::shared_ptr<const Outline>> outlines;                   // by hash
  std::map<std::pair<std::shared_ptr<const Outline>, Coord>, std::shared_ptr<const Outline>> grown;  // by tolerance
  Entries entries;
  std::unordered_map<Key, Entries::iterator, KeyHash> index;
  CacheCounts counts;

  Sum find(const Key& key) {
    const std::lock_guard lock{mutex};
    const auto at = index.find(key);
    if (at == index.end()) return nullptr;
    entries.splice(entries.begin(), entries, at->second);
    return at->second->sum;
  }

  void count(std::size_t hits, std::size_t misses) {
    const std::lock_guard lock{mutex};
    counts.hits += hits;
    counts.misses += misses;
  }

  // Keeps the sum, unless another thread was faster.
  void keep(const Key& key, const Sum& sum) {
    const std::lock_guard lock{mutex};
    if (index.contains(key)) return;
    entries.push_front({key, sum, sum->bytes()});
    index.emplace(key, entries.begin());
    counts.bytes += entries.front().bytes;
    while (counts.bytes > limit && !entries.empty()) {
      counts.bytes -= entries.back().bytes;
      index.erase(entries.back().key);
      entries.pop_back();
    }
  }
};

std::shared_ptr<const Outline> SumCache::outline(const Polygon& polygon) {
  const std::uint64_t hash = hash_of(polygon);
  const auto known = [&]() -> std::shared_ptr<const Outline> {
    const auto [first, last] = store_->outlines.equal_range(hash);
    for (auto at = first; at != last; ++at) {
      if (at->second->polygon == polygon) return at->second;
    }
    return nullptr;
  };
  {
    const std::lock_guard lock{store_->mutex};
    if (auto outline = known()) return outline;
  }
  auto made = make_outline(polygon);
  const std::lock_guard lock{store_->mutex};
  if (auto outline = known()) return outline;
  if (store_->outlines.size() >= Store::kOutlines) store_->outlines.clear();
  store_->outlines.emplace(hash, made);
  return made;
}

std::shared_ptr<const Outline> SumCache::grown(const std::shared_ptr<const Outline>& outline, Coord tolerance) {
  const std::pair key{outline, tolerance};
  {
    const std::lock_guard lock{store_->mutex};
    if (const auto known = store_->grown.find(key); known != store_->grown.end()) return known->second;
  }
  Polygon simplified = simplified_outward(outline->polygon, tolerance);
  auto made = simplified.size() == outline->polygon.size() ? outline : this->outline(simplified);
  const std::lock_guard lock{store_->mutex};
  if (store_->grown.size() >= Store::kOutlines) store_->grown.clear();
  return store_->grown.emplace(key, std::move(made)).first->second;
}

SumCache::SumCache(std::size_t limit_bytes) : store_{std::make_unique<Store>()} {
  store_->limit = limit_bytes;
}
SumCache::~SumCache() = default;

Obstacle SumCache::obstacle(const OrientedOutline& p, const OrientedOutline& q) {
  const Kept kept = kept_as(p, q);
  Sum sum = store_->find(kept.key);
  store_->count(sum ? 1 : 0, sum ? 0 : 1);
  if (!sum) {
    sum = make(kept.key);
    store_->keep(kept.key, sum);
  }
  return {std::move(sum), kept.frame, kept.swapped};
}

std::vector<Obstacle> SumCache::obstacles(std::span<const OutlinePair> pairs, const Crew& crew) {
  std::vector<Kept> kept;
  std::vector<Sum> sums;
  kept.reserve(pairs.size());
  sums.reserve(pairs.size());
  std::vector<Key> missing;
  std::unordered_map<Key, std::size_t, KeyHash> number;  // of each that is missing
  for (const auto& [p, q] : pairs) {
    const Key& key = kept.emplace_back(kept_as(*p, *q)).key;
    sums.push_back(store_->find(key));
    if (!sums.back() && number.try_emplace(key, missing.size()).second) missing.push_back(key);
  }
  store_->count(pairs.size() - missing.size(), missing.size());

  const auto made = gathered<Sum>(crew, missing.size(), kBlock,
                                  [&](std::size_t k, std::vector<Sum>& out) { out.push_back(make(missing[k])); });
  for (std::size_t k = 0; k < missing.size(); ++k) store_->keep(missing[k], made[k]);

  std::vector<Obstacle> obstacles;
  obstacles.reserve(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (!sums[k]) sums[k] = made[number.at(kept[k].key)];
    obstacles.emplace_back(std::move(sums[k]), kept[k].frame, kept[k].swapped);
  }
  return obstacles;
}

CacheCounts SumCache::counts() const {
  const std::lock_guard lock{store_->mutex};
  CacheCounts counts = store_->counts;
  counts.entries = store_->entries.size();
  counts.limit = store_->limit;
  return counts;
}

}  // namespace selvage
