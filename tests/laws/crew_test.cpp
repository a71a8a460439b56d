// The same request gives the same bytes with any number of threads.
#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/marker/validity.h"
#include "core/motion/push.h"
#include "core/motion/refine.h"
#include "core/motion/tilt.h"
#include "server/crew/thread_crew.h"
#include "tests/laws/random_marker.h"
#include "tests/laws/random_settings.h"
#include "tests/support/garment.h"
#include "tests/support/tiled_marker.h"

namespace selvage {
namespace {

using test::kSlowdown;
using test::Random;

// What a motion came to, and all that is told of it.
struct Story {
  Marker marker;
  StopReason reason{};
  int rounds{}, programs{};
  std::vector<Coord> lengths;           // after each round
  std::array<std::uint64_t, 4> sums{};  // the cache's: hits, misses, entries, bytes
  friend bool operator==(const Story&, const Story&) = default;
};

// Of motion(sums, stop, observer), from an empty cache.
template <class Motion>
Story story_of(const Crew& crew, const Motion& motion, std::stop_source stop = {}) {
  Story story;
  SumCache sums;
  Observer observer;
  observer.crew = &crew;
  observer.on_round = [&](const Round& round) { story.lengths.push_back(round.length); };
  auto done = motion(sums, stop.get_token(), observer);
  if (!done) throw std::runtime_error{done.error().message};
  story.marker = std::move(done->marker);
  story.reason = done->reason;
  story.rounds = done->rounds;
  story.programs = done->programs;
  const CacheCounts counts = sums.counts();
  story.sums = {counts.hits, counts.misses, counts.entries, counts.bytes};
  return story;
}

template <class Motion>
void expect_one_story(const Motion& motion, const std::string& about) {
  const Story alone_told = story_of(alone(), motion);
  EXPECT_TRUE(is_valid(alone_told.marker)) << about;
  for (const std::size_t threads : {1U, 2U, 4U, 7U}) {
    EXPECT_TRUE(story_of(ThreadCrew{threads - 1}, motion) == alone_told) << about << ", " << threads << " threads";
  }
}

auto compaction(const Marker& marker, const CompactionSettings& settings) {
  return [&marker, settings](SumCache& sums, const std::stop_token& stop, const Observer& observer) {
    return compact(marker, settings, sums, stop, observer);
  };
}
auto standard(const Marker& marker) {
  return compaction(marker, compaction_settings(Accuracy::kStandard));
}

class GarmentCrews : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, GarmentCrews, test::kGarments, test::garment_name);

TEST_P(GarmentCrews, Compact) {
  const Marker marker = test::garment(GetParam());
  expect_one_story(standard(marker), GetParam());
  CompactionSettings walking = compaction_settings(Accuracy::kDraft);
  walking.region = RegionRule::kWalk;
  expect_one_story(compaction(marker, walking), GetParam());
}

TEST_P(GarmentCrews, HealAndPush) {
  Random random{161};
  Marker marker = test::garment(GetParam());
  marker = test::shaken(random, marker, 2e-5);
  ASSERT_FALSE(is_valid(marker));
  const std::vector<Force> forces{{PieceId{1}, 1, 0}, {PieceId{4}, 0.5, 1}};
  expect_one_story(
      [&](SumCache& sums, const std::stop_token& stop, const Observer& observer) {
        return push(marker, forces, compaction_settings(Accuracy::kDraft), sums, stop, observer);
      },
      GetParam());
}

TEST(Crews, CompactLongMarkers) {
  const Marker marker = test::tiled(test::garment("jeans_02g"), 1200 / kSlowdown);
  const Marker loose = test::loosened(marker, 0.05);
  expect_one_story(standard(loose), "1200 pieces");
}

TEST(Crews, CompactRandomMarkers) {
  Random random{162};
  for (int trial = 0; trial < 60 / kSlowdown; ++trial) {
    const Marker marker = test::tiled(test::random_marker(random), 70);
    expect_one_story(compaction(marker, random_settings(random)), std::to_string(trial));
  }
}

TEST(Crews, Tilt) {
  for (const char* name : {"jeans_02g", "charlie_04g"}) {
    const Marker marker = test::garment(name);
    for (const TiltMethod method : {TiltMethod::kLinearisation, TiltMethod::kRelaxation}) {
      TiltSettings settings = tilt_settings(method, Accuracy::kDraft);
      settings.rounds = 2;
      settings.shakes = 0;
      expect_one_story([&](SumCache& sums, const std::stop_token& stop,
                           const Observer& observer) { return tilt(marker, settings, sums, stop, observer); },
                       name);
    }
  }
}

// The answer, not the cache: exchanges that are tried for nothing look up sums, too.
TEST(Crews, Refine) {
  for (const char* name : {"jeans_02g", "charlie_04g"}) {
    const Marker marker = test::garment(name);
    RefineSettings settings = refine_settings();
    settings.effort = 6'000 / kSlowdown;
    expect_one_story(
        [&](SumCache&, const std::stop_token& stop, const Observer& observer) {
          SumCache own;
          return refine(marker, settings, own, stop, observer);
        },
        name);
  }
}

// Lets another crew work, and does something of its own before one of the parts.
class Interrupted final : public Crew {
 public:
  Interrupted(const Crew& crew, int part, std::function<void()> act) : crew_{crew}, left_{part}, act_{std::move(act)} {}
  [[nodiscard]] std::size_t hands() const override { return crew_.hands(); }
  void each(std::size_t count, const Part& part) const override {
    crew_.each(count, [&](std::size_t k) {
      if (left_-- == 0) act_();
      part(k);
    });
  }

 private:
  const Crew& crew_;
  mutable std::atomic<int> left_;
  std::function<void()> act_;
};

TEST(Crews, AnswerWithTheBestSoFarWhenStoppedInAPart) {
  const Marker marker = test::garment("jeans_06g");
  const ThreadCrew crew{2};
  for (const int part : {0, 5, 20, 35}) {
    std::stop_source stop;
    const Interrupted interrupted{crew, part, [&] { stop.request_stop(); }};
    const Story story = story_of(interrupted, standard(marker), stop);
    EXPECT_EQ(story.reason, StopReason::kCancelled) << part;
    EXPECT_TRUE(is_valid(story.marker)) << part;
    EXPECT_LE(length_of(story.marker), length_of(marker)) << part;
  }
}

TEST(Crews, RefineAnswersWithTheBestSoFarWhenStoppedInAPart) {
  const Marker marker = test::garment("jeans_02g");
  const ThreadCrew crew{2};
  for (const int part : {3, 12, 17, 30}) {
    std::stop_source stop;
    const Interrupted interrupted{crew, part, [&] { stop.request_stop(); }};
    const Story story = story_of(
        interrupted,
        [&](SumCache& sums, const std::stop_token& token, const Observer& observer) {
          return refine(marker, refine_settings(), sums, token, observer);
        },
        stop);
    EXPECT_EQ(story.reason, StopReason::kCancelled) << part;
    EXPECT_TRUE(is_valid(story.marker)) << part;
    EXPECT_LE(length_of(story.marker), length_of(marker)) << part;
    if (story.rounds == 0) continue;  // in the compaction that comes first
    ASSERT_FALSE(story.lengths.empty()) << part;
    EXPECT_EQ(story.lengths.back(), length_of(story.marker)) << part;
  }
}

TEST(Crews, ThrowWhatAPartThrowsAndWorkOn) {
  const Marker marker = test::garment("jeans_06g");
  const ThreadCrew crew{2};
  const Story expected = story_of(crew, standard(marker));
  SumCache sums;
  for (const int part : {0, 5, 20}) {
    const Interrupted interrupted{crew, part, [] { throw std::runtime_error{"a bug"}; }};
    Observer observer;
    observer.crew = &interrupted;
    EXPECT_THROW((void)compact(marker, compaction_settings(Accuracy::kStandard), sums, {}, observer),
                 std::runtime_error);
  }
  EXPECT_EQ(compact(marker, compaction_settings(Accuracy::kStandard), sums)->marker, expected.marker);
  EXPECT_TRUE(story_of(crew, standard(marker)) == expected);
}

}  // namespace
}  // namespace selvage
