// The garment markers of examples/, through a whole daemon and the real engine.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "server/daemon.h"
#include "tests/end_to_end/calls.h"

namespace selvage::test {
namespace {

class Garments : public ::testing::TestWithParam<const char*> {};

TEST_P(Garments, OpenCompactCheckGetClose) {
  Daemon daemon{on_free_port(1)};
  Wire wire{daemon.port()};
  const Json opened = result_of(post_call(wire, "marker.open", open_params(garment(GetParam()))));
  ASSERT_FALSE(opened.is_null());
  EXPECT_EQ(opened["valid"], true);
  const std::string id = opened["markerId"];

  const Json compacted = result_of(post_call(wire, "motion.compact", id_params(id, R"(,"baseRev":1)")));
  ASSERT_FALSE(compacted.is_null());
  EXPECT_EQ(compacted["lengthBefore"], opened["length"]);
  EXPECT_LT(compacted["lengthAfter"], compacted["lengthBefore"]);
  EXPECT_EQ(compacted["revision"], 2);
  EXPECT_EQ(compacted["valid"], true);

  const Json checked = result_of(post_call(wire, "marker.check", id_params(id)));
  EXPECT_EQ(checked["valid"], true) << checked.dump().substr(0, 500);
  EXPECT_EQ(checked["revision"], 2);

  const Json outlines = result_of(post_call(wire, "marker.get", id_params(id, R"(,"format":"outlines")")));
  EXPECT_EQ(outlines["marker"]["pieces"].size(), opened["pieces"]);
  // What is handed out can be opened again, and is as long as was said.
  const Json native = result_of(post_call(wire, "marker.get", id_params(id)));
  const Json again = result_of(post_call(wire, "marker.open", open_params(native["marker"].dump())));
  EXPECT_EQ(again["length"], compacted["lengthAfter"]);

  EXPECT_EQ(result_of(post_call(wire, "marker.close", id_params(id)))["closed"], true);
  EXPECT_EQ(code_of(post_call(wire, "marker.get", id_params(id))), -32012);
}

INSTANTIATE_TEST_SUITE_P(All, Garments,
                         ::testing::Values("jeans_02g", "charlie_04g", "simon_06g", "jeans_06g", "jeans_22g"),
                         [](const auto& tested) { return std::string{tested.param}; });

// What one client sees: a dry run, the motion itself, the outlines.
std::array<std::string, 3> seen(std::uint16_t port, const std::string& document) {
  Wire wire{port};
  const std::string id = open_marker(wire, document);
  return {post_call(wire, "motion.compact", id_params(id, R"(,"commit":false)")),
          post_call(wire, "motion.compact", id_params(id)),
          post_call(wire, "marker.get", id_params(id, R"(,"format":"outlines")"))};
}

// The answer without the id of its marker, which the order of opening decides.
std::string without_id(std::string answer) {
  const std::size_t at = answer.find(R"("markerId":"m)");
  EXPECT_NE(at, std::string::npos);
  return answer.erase(at, answer.find(',', at) - at);
}

TEST(SameBytes, OnAnyNumberOfWorkersAndEveryRun) {
  const std::string document = garment("jeans_02g");
  std::set<std::array<std::string, 3>> different;
  for (int run = 0; run < 10; ++run) {
    for (const std::size_t workers : {1U, 2U}) {
      Daemon daemon{on_free_port(workers)};
      std::array<std::string, 3> first;
      std::array<std::string, 3> second;
      {
        const std::jthread beside{[&] { second = seen(daemon.port(), document); }};
        first = seen(daemon.port(), document);
      }
      for (auto* answers : {&first, &second}) {
        for (std::string& answer : *answers) answer = without_id(answer);
        EXPECT_NE((*answers)[1].find("\"result\""), std::string::npos);
        different.insert(*answers);
      }
    }
  }
  EXPECT_EQ(different.size(), 1U);
}

TEST(Sums, AreSharedByAllMarkers) {
  Daemon daemon{on_free_port(1)};
  (void)seen(daemon.port(), garment("jeans_02g"));
  const CacheCounts cold = daemon.sums().counts();
  EXPECT_GT(cold.misses, 0U);
  (void)seen(daemon.port(), garment("jeans_02g"));
  const CacheCounts warm = daemon.sums().counts();
  EXPECT_EQ(warm.misses, cold.misses);
  EXPECT_GT(warm.hits, cold.hits);
}

}  // namespace
}  // namespace selvage::test
