#include "core/minkowski/cache.h"

#include <functional>
#include <iterator>
#include <list>
#include <mutex>
#include <unordered_map>

#include "core/outline/outward.h"

namespace selvage::minkowski {
namespace {

// Two outlines and their relative orientation: pairs with equal keys have equal sums.
struct Key {
  std::shared_ptr<const outline::Outline> p, q;
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

// True when the pair (p, q) is stored as (q, p), so that both orders share one entry.
bool stored_swapped(const outline::OrientedOutline& p, const outline::OrientedOutline& q) {
  const outline::Outline& a = *p.outline;
  const outline::Outline& b = *q.outline;
  if (a.hash != b.hash) return a.hash > b.hash;
  if (a.polygon != b.polygon) return a.polygon > b.polygon;
  const Symmetry forth = p.symmetry.inverse().after(q.symmetry);
  return forth.inverse().index() < forth.index();
}

// The key under which a pair's sum is stored, and how the pair relates to it.
struct StoredAs {
  Key key;
  Symmetry frame;
  bool swapped{};
};
StoredAs stored_as(const outline::OrientedOutline& p, const outline::OrientedOutline& q) {
  const bool swapped = stored_swapped(p, q);
  const outline::OrientedOutline& first = swapped ? q : p;
  const outline::OrientedOutline& second = swapped ? p : q;
  return {{first.outline, second.outline, first.symmetry.inverse().after(second.symmetry)}, first.symmetry, swapped};
}

using Sum = std::shared_ptr<const MinkowskiSum>;
// Null when cancelled.
Sum make(const Key& key, const std::function<bool()>& stopped) {
  auto sum = obstacle_sum(*key.p, *key.q, key.relative, stopped);
  return sum ? std::make_shared<const MinkowskiSum>(*std::move(sum)) : nullptr;
}

constexpr std::size_t kBlock = 4;  // consecutive sums computed by one part of the parallel task

}  // namespace

struct SumCache::Store {
  struct SumEntry {
    Key key;
    Sum sum;
    std::size_t bytes{};
    std::uint64_t used{};  // serial number of its last use
  };
  // The simplification of an outline, as long as its outline is alive elsewhere.
  struct Simplified {
    Coord tolerance{};
    std::weak_ptr<const outline::Outline> outline;
  };
  static constexpr std::size_t kSimplifiedPerOutline = 4;  // how many tolerances are remembered for one outline
  struct OutlineEntry {
    std::shared_ptr<const outline::Outline> outline;
    std::size_t bytes{};
    std::uint64_t
        used{};  // serial number of its last use, or of its sums' last use, so that its sums are evicted first
    std::vector<Simplified> grown{};
  };
  // Both lists are ordered by last use, most recent first.
  using Sums = std::list<SumEntry>;
  using Outlines = std::list<OutlineEntry>;

  std::size_t limit{};
  mutable std::mutex mutex;
  Sums sums;
  Outlines outlines;
  std::unordered_map<Key, Sums::iterator, KeyHash> sum_at;
  std::unordered_multimap<std::uint64_t, Outlines::iterator> outline_at;  // by hash
  std::uint64_t uses{};
  CacheCounts counts;

  Sum find(const Key& key) {
    const std::lock_guard lock{mutex};
    const auto at = sum_at.find(key);
    if (at == sum_at.end()) return nullptr;
    use(at->second);
    return at->second->sum;
  }

  void count(std::size_t hits, std::size_t misses) {
    const std::lock_guard lock{mutex};
    counts.hits += hits;
    counts.misses += misses;
  }

  // Stores the sum, unless another thread has stored it meanwhile.
  void keep(const Key& key, const Sum& sum) {
    const std::lock_guard lock{mutex};
    if (sum_at.contains(key)) return;
    sums.push_front({key, sum, sum->bytes()});
    sum_at.emplace(key, sums.begin());
    counts.bytes += sums.front().bytes;
    use(sums.begin());
    make_room();
  }

  // The stored outline of the polygon, or null.
  std::shared_ptr<const outline::Outline> find(const Polygon& polygon, std::uint64_t hash) {
    const std::lock_guard lock{mutex};
    const auto known = use(polygon, hash);
    return known == outlines.end() ? nullptr : known->outline;
  }

  // The remembered simplification of the outline for this tolerance, or null.
  std::shared_ptr<const outline::Outline> find_grown(const outline::Outline& outline, Coord tolerance) {
    const std::lock_guard lock{mutex};
    const auto known = use(outline.polygon, outline.hash);
    if (known == outlines.end()) return nullptr;
    for (const Simplified& grown : known->grown) {
      if (grown.tolerance == tolerance) return grown.outline.lock();
    }
    return nullptr;
  }
  // Remembers a simplification for as long as the outline is stored.
  void keep_grown(const outline::Outline& outline, Coord tolerance,
                  const std::shared_ptr<const outline::Outline>& simplified) {
    const std::lock_guard lock{mutex};
    const auto known = use(outline.polygon, outline.hash);
    if (known == outlines.end()) return;
    std::vector<Simplified>& grown = known->grown;
    std::erase_if(grown, [&](const Simplified& one) { return one.tolerance == tolerance; });
    if (grown.size() == kSimplifiedPerOutline) grown.erase(grown.begin());
    grown.push_back({tolerance, simplified});
  }

  // Stores the outline and returns it, or returns the one that another thread has stored meanwhile.
  std::shared_ptr<const outline::Outline> keep(const std::shared_ptr<const outline::Outline>& made) {
    const std::lock_guard lock{mutex};
    if (const auto known = use(made->polygon, made->hash); known != outlines.end()) return known->outline;
    outlines.push_front({made, made->bytes(), ++uses});
    outline_at.emplace(made->hash, outlines.begin());
    counts.bytes += outlines.front().bytes;
    make_room();
    return made;
  }

 private:
  void use(Sums::iterator sum) {
    sum->used = ++uses;
    sums.splice(sums.begin(), sums, sum);
    use(sum->key.p->polygon, sum->key.p->hash);
    use(sum->key.q->polygon, sum->key.q->hash);
  }
  Outlines::iterator use(const Polygon& polygon, std::uint64_t hash) {
    const auto [first, last] = outline_at.equal_range(hash);
    for (auto at = first; at != last; ++at) {
      const auto known = at->second;
      if (&known->outline->polygon != &polygon && known->outline->polygon != polygon) continue;
      known->used = ++uses;
      outlines.splice(outlines.begin(), outlines, known);
      return known;
    }
    return outlines.end();
  }

  // Evicts the least recently used entries until the rest fits the limit.
  void make_room() {
    while (counts.bytes > limit && !(sums.empty() && outlines.empty())) {
      if (outlines.empty() || (!sums.empty() && sums.back().used < outlines.back().used)) {
        counts.bytes -= sums.back().bytes;
        sum_at.erase(sums.back().key);
        sums.pop_back();
      } else {
        forget(std::prev(outlines.end()));
      }
    }
  }
  void forget(Outlines::iterator outline) {
    counts.bytes -= outline->bytes;
    auto at = outline_at.equal_range(outline->outline->hash).first;
    while (at->second != outline) ++at;
    outline_at.erase(at);
    outlines.erase(outline);
  }
};

std::shared_ptr<const outline::Outline> SumCache::outline(const Polygon& polygon) {
  if (auto known = store_->find(polygon, outline::hash_of(polygon))) return known;
  return store_->keep(outline::make_outline(polygon));
}

std::shared_ptr<const outline::Outline> SumCache::grown(const std::shared_ptr<const outline::Outline>& outline,
                                                        Coord tolerance) {
  if (auto known = store_->find_grown(*outline, tolerance)) return known;
  Polygon simplified = outline::simplified_outward(outline->polygon, tolerance);
  auto made = simplified.size() == outline->polygon.size() ? outline : this->outline(simplified);
  store_->keep_grown(*outline, tolerance, made);
  return made;
}

SumCache::SumCache(std::size_t limit_bytes) : store_{std::make_unique<Store>()} {
  store_->limit = limit_bytes;
}
SumCache::~SumCache() = default;

Obstacle SumCache::obstacle(const outline::OrientedOutline& p, const outline::OrientedOutline& q) {
  return *obstacle(p, q, {});
}

std::optional<Obstacle> SumCache::obstacle(const outline::OrientedOutline& p, const outline::OrientedOutline& q,
                                           const std::stop_token& stop) {
  const StoredAs kept = stored_as(p, q);
  Sum sum = store_->find(kept.key);
  store_->count(sum ? 1 : 0, sum ? 0 : 1);
  if (!sum) {
    sum = make(kept.key, [&stop] { return stop.stop_requested(); });
    if (!sum) return {};
    store_->keep(kept.key, sum);
  }
  return Obstacle{std::move(sum), kept.frame, kept.swapped};
}

std::vector<Obstacle> SumCache::obstacles(std::span<const OutlinePair> pairs, const Executor& executor,
                                          const std::stop_token& stop) {
  std::vector<StoredAs> kept;
  std::vector<Sum> sums;
  kept.reserve(pairs.size());
  sums.reserve(pairs.size());
  std::vector<Key> missing;
  std::unordered_map<Key, std::size_t, KeyHash> number;  // of each missing key in `missing`
  for (const auto& [p, q] : pairs) {
    const Key& key = kept.emplace_back(stored_as(*p, *q)).key;
    sums.push_back(store_->find(key));
    if (!sums.back() && number.try_emplace(key, missing.size()).second) missing.push_back(key);
  }
  store_->count(pairs.size() - missing.size(), missing.size());

  const auto made = gathered<Sum>(executor, missing.size(), kBlock, [&](std::size_t k, std::vector<Sum>& out) {
    const auto stopped = [&executor, &stop] {
      executor.on_step();
      return stop.stop_requested();
    };
    out.push_back(stopped() ? nullptr : make(missing[k], stopped));
  });
  for (std::size_t k = 0; k < missing.size(); ++k) {
    if (!made[k]) return {};
    store_->keep(missing[k], made[k]);
  }

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
  counts.entries = store_->sums.size();
  counts.limit = store_->limit;
  return counts;
}

}  // namespace selvage::minkowski
