// The program itself: started, told to stop, and used by the curl example.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/end_to_end/calls.h"
#include "tests/end_to_end/process.h"

namespace selvage::test {
namespace {

class Selvaged : public ::testing::Test {
 protected:
  Selvaged() {
    std::string name = (std::filesystem::temp_directory_path() / "selvaged-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
  }
  ~Selvaged() override { std::filesystem::remove_all(folder_); }

  // Started with these options on a free port; port_ is told when it listens.
  std::vector<std::string> words(std::vector<std::string> more = {}) const {
    std::vector<std::string> all{SELVAGED, "--listen", "127.0.0.1:0", "--port-file", port_file()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  std::string port_file() const { return (folder_ / "port").string(); }
  std::uint16_t port_of(Process& process) const {
    EXPECT_NE(process.output_until("listening on 127.0.0.1:").find("listening on 127.0.0.1:"), std::string::npos);
    return static_cast<std::uint16_t>(std::stoi(file_text(port_file())));
  }

  std::filesystem::path folder_;
};

TEST_F(Selvaged, SaysWhereItListensAndEndsInOrderOnBothSignals) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Process selvaged{words()};
    const std::uint16_t port = port_of(selvaged);
    Wire wire{port};
    EXPECT_EQ(result_of(post_call(wire, "engine.info"))["name"], "selvage");
    selvaged.signal(signal);
    EXPECT_EQ(wire.rest(), "");
    EXPECT_EQ(selvaged.exit_code(), 0);
    const std::string output = selvaged.all_output();
    EXPECT_NE(output.find("listening on 127.0.0.1:" + std::to_string(port) + "\n"), std::string::npos) << output;
    EXPECT_NE(output.find("engine.info - "), std::string::npos) << output;
    EXPECT_NE(output.find("drained"), std::string::npos) << output;
  }
}

TEST_F(Selvaged, StoppedInTheMiddleOfMotionsAnswersThemAll) {
  Process selvaged{words({"--workers", "1"})};
  const std::uint16_t port = port_of(selvaged);
  Wire wire{port};
  const std::string id = open_marker(wire, garment("jeans_22g"));
  Wire lines{port};
  std::string calls;
  for (int i = 0; i < 20; ++i) {
    calls += call(i, "motion.compact", id_params(id, R"(,"commit":false,"accuracy":"fine")")) + "\n";
  }
  lines.send(calls);
  lines.send(call(20, "engine.info") + "\n");
  // Answered at once, and read after the motions: they are all accepted by now, and cannot all be done.
  std::vector<std::string> answers;
  do {
    answers.push_back(lines.line().value_or(R"({"id":20,"error":{"code":0}})"));
  } while (Json::parse(answers.back())["id"] != 20);
  selvaged.signal(SIGTERM);
  while (const auto line = lines.line()) answers.push_back(*line);
  EXPECT_EQ(selvaged.exit_code(), 0);
  EXPECT_EQ(answers.size(), 21U);
  for (const std::string& answer : answers) {
    const Json result = result_of(answer);
    if (result.contains("stop")) {
      EXPECT_EQ(result["valid"], true);
      EXPECT_LE(result["lengthAfter"], result["lengthBefore"]);
    }
  }
  EXPECT_EQ(Json::parse(answers.back())["result"]["stop"], "cancelled");
}

TEST_F(Selvaged, RefusesAForeignAddressAndATakenPort) {
  Process foreign{{SELVAGED, "--listen", "0.0.0.0:0"}};
  EXPECT_NE(foreign.all_output().find("not a loopback address"), std::string::npos);
  EXPECT_EQ(foreign.exit_code(), 2);
  Process first{words()};
  const std::string address = "127.0.0.1:" + std::to_string(port_of(first));
  Process second{{SELVAGED, "--listen", address}};
  EXPECT_NE(second.all_output().find("cannot serve on " + address), std::string::npos);
  EXPECT_EQ(second.exit_code(), 1);
}

TEST_F(Selvaged, ServesTheCurlExample) {
  Process selvaged{words()};
  ::setenv("SELVAGED", ("127.0.0.1:" + std::to_string(port_of(selvaged))).c_str(), 1);
  const std::string source = SELVAGE_SOURCE_DIR;
  const std::string outlines = (folder_ / "outlines.json").string();
  Process script{{source + "/examples/curl/compact.sh", source + "/examples/markers/jeans_02g.json", outlines}};
  const std::string output = script.all_output();
  EXPECT_EQ(script.exit_code(), 0) << output;
  EXPECT_NE(output.find("length 2460.35 -> "), std::string::npos) << output;
  const Json saved = Json::parse(file_text(outlines));
  EXPECT_EQ(saved["pieces"].size(), 40U);
  EXPECT_LT(saved["strip_length"], 2460.35);

  Process missing{{source + "/examples/curl/compact.sh", source + "/README.md", outlines}};
  EXPECT_NE(missing.all_output().find("selvaged: "), std::string::npos);
  EXPECT_NE(missing.exit_code(), 0);
}

}  // namespace
}  // namespace selvage::test
