// The garment markers of examples/ through a whole daemon.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "server/app/daemon.h"
#include "tests/end_to_end/calls.h"

namespace selvage::test {
namespace {

class Garments : public ::testing::TestWithParam<const char*> {};

TEST_P(Garments, CanBeOpenedCompactedCheckedReadAndClosed) {
  server::app::Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  const Json opened = result_of(post_call(wire, "marker.open", open_params(garment(GetParam()))));
  ASSERT_FALSE(opened.is_null());
  EXPECT_EQ(opened["valid"], true);
  const std::string id = opened["markerId"].text();

  const Json compacted = result_of(post_call(wire, "motion.compact", id_params(id, R"(,"baseRev":1)")));
  ASSERT_FALSE(compacted.is_null());
  EXPECT_EQ(compacted["lengthBefore"], opened["length"]);
  EXPECT_LT(compacted["lengthAfter"], compacted["lengthBefore"]);
  EXPECT_EQ(compacted["revision"], 2);
  EXPECT_EQ(compacted["valid"], true);

  const Json checked = result_of(post_call(wire, "marker.check", id_params(id)));
  EXPECT_EQ(checked["valid"], true) << protocol::json::to_text(checked).substr(0, 500);
  EXPECT_EQ(checked["revision"], 2);

  const Json outlines = result_of(post_call(wire, "marker.get", id_params(id, R"(,"format":"outlines")")));
  EXPECT_EQ(outlines["marker"]["pieces"].size(), opened["pieces"]);
  // The returned document can be opened again and has the reported length.
  const Json native = result_of(post_call(wire, "marker.get", id_params(id)));
  const Json again = result_of(post_call(wire, "marker.open", open_params(protocol::json::to_text(native["marker"]))));
  EXPECT_EQ(again["length"], compacted["lengthAfter"]);

  EXPECT_EQ(result_of(post_call(wire, "marker.close", id_params(id)))["closed"], true);
  EXPECT_EQ(code_of(post_call(wire, "marker.get", id_params(id))), -32012);
}

INSTANTIATE_TEST_SUITE_P(All, Garments,
                         ::testing::Values("jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g"),
                         [](const auto& tested) { return std::string{tested.param}; });

// The answers that one client receives: to a dry run, to motions and to reads.
using Seen = std::array<std::string, 5>;
Seen seen(std::uint16_t port, const std::string& document) {
  Wire wire{port};
  const std::string id = open_marker(wire, document);
  return {post_call(wire, "motion.compact", id_params(id, R"(,"commit":false)")),
          post_call(wire, "motion.compact", id_params(id)),
          post_call(wire, "motion.gravity", id_params(id, R"(,"force":[0.1,-1])")),
          post_call(wire, "motion.bump", id_params(id, R"(,"piece":"7","direction":[1,1])")),
          post_call(wire, "marker.get", id_params(id, R"(,"format":"outlines")"))};
}

// The answer without the id of its marker, which the order of opening decides.
std::string without_id(std::string answer) {
  const std::size_t at = answer.find(R"("markerId":"m)");
  EXPECT_NE(at, std::string::npos);
  return answer.erase(at, answer.find(',', at) - at);
}

// A garment marker whose pieces were moved apart: every motion leaves it valid and does not lengthen it.
TEST(Motions, WorkOnAGarmentMarkerThroughTheDaemon) {
  server::app::Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  const std::string id = open_marker(wire, garment("jeans_06g"));
  const Json compacted = result_of(post_call(wire, "motion.compact", id_params(id)));
  const Json fallen = result_of(post_call(wire, "motion.gravity", id_params(id, R"(,"force":[0,-1])")));
  EXPECT_EQ(fallen["valid"], true);
  EXPECT_GT(fallen["gain"], 0);
  EXPECT_LE(fallen["lengthAfter"], compacted["lengthAfter"]);
  EXPECT_EQ(fallen["revision"], 3);
  const Json pushed = result_of(
      post_call(wire, "motion.push", id_params(id, R"(,"forces":[{"piece":"17","force":[0,1]}],"rounds":2)")));
  EXPECT_EQ(pushed["valid"], true);
  EXPECT_LE(pushed["rounds"], 2);
  for (const char* piece : {"0", "17", "119"}) {
    const Json bumped = result_of(post_call(
        wire, "motion.bump", id_params(id, R"(,"direction":[-1,-0.5],"piece":")" + std::string{piece} + "\"")));
    EXPECT_EQ(bumped["valid"], true);
    EXPECT_LE(bumped["lengthAfter"], bumped["lengthBefore"]);
  }
  EXPECT_EQ(result_of(post_call(wire, "marker.check", id_params(id)))["valid"], true);
}

TEST(Answers, AreTheSameBytesForAnyNumberOfWorkersAndInEveryRun) {
  const std::string document = garment("jeans_02g");
  std::set<Seen> different;
  for (int run = 0; run < 10; ++run) {
    for (const std::size_t workers : {1U, 2U}) {
      server::app::Daemon daemon{on_free_port(workers)};
      Seen first;
      Seen second;
      {
        const std::jthread beside{[&] { second = seen(daemon.port(), document); }};
        first = seen(daemon.port(), document);
      }
      for (auto* answers : {&first, &second}) {
        for (std::string& answer : *answers) answer = without_id(answer);
        for (const std::string& answer : *answers) EXPECT_NE(answer.find("\"result\""), std::string::npos);
        different.insert(*answers);
      }
    }
  }
  EXPECT_EQ(different.size(), 1U);
}

TEST(Sums, AreSharedByAllMarkers) {
  server::app::Daemon daemon{on_free_port(1)};
  (void)seen(daemon.port(), garment("jeans_02g"));
  const minkowski::CacheCounts cold = daemon.sums().counts();
  EXPECT_GT(cold.misses, 0U);
  (void)seen(daemon.port(), garment("jeans_02g"));
  const minkowski::CacheCounts warm = daemon.sums().counts();
  EXPECT_EQ(warm.misses, cold.misses);
  EXPECT_GT(warm.hits, cold.hits);
}

}  // namespace
}  // namespace selvage::test
