// The program itself: start, shutdown, configuration, and the curl example.

#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/end_to_end/selvaged_test.h"

namespace selvage::test {
namespace {

class Selvaged : public SelvagedTest {};

TEST_F(Selvaged, PrintsItsAddressesAndShutsDownOnBothSignals) {
  for (const int signal : {SIGTERM, SIGINT}) {
    Process selvaged{arguments()};
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

TEST_F(Selvaged, AnswersAllMotionsWhenItIsStopped) {
  Process selvaged{arguments({"--workers", "1"})};
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
  // This call is answered immediately and was read after the motions: all of them are accepted by now, but not done.
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

TEST_F(Selvaged, RefusesAForeignAddressAndAPortInUse) {
  Process foreign{{SELVAGED, "--listen", "0.0.0.0:0"}};
  EXPECT_NE(foreign.all_output().find("--token-file is missing"), std::string::npos);
  EXPECT_EQ(foreign.exit_code(), 2);
  Process first{arguments()};
  const std::string address = "127.0.0.1:" + std::to_string(port_of(first));
  Process second{{SELVAGED, "--listen", address}};
  EXPECT_NE(second.all_output().find("cannot listen on 127.0.0.1 port "), std::string::npos);
  EXPECT_EQ(second.exit_code(), 1);
}

TEST_F(Selvaged, ListensOnTheGivenAddressesAndPrintsThem) {
  const std::string path = folder_.file("socket");
  Process selvaged{arguments({"--listen-tcp", "127.0.0.1:0", "--listen-unix", path})};
  EXPECT_NE(selvaged.output_until("listening on " + path).find("listening on " + path), std::string::npos);
  std::istringstream ports{file_text(folder_.file("port"))};
  std::uint16_t http{};
  std::uint16_t lines{};
  ASSERT_TRUE(ports >> http >> lines);
  Wire by_lines{lines};
  Wire by_path{path};
  for (Wire* wire : {&by_lines, &by_path}) {
    wire->send(call(1, "engine.info") + "\n");
    EXPECT_EQ(result_of(wire->line().value_or(""))["name"], "selvage");
  }
  Wire page{http};
  page.send("GET /metrics HTTP/1.1\r\nHost: localhost\r\n\r\n");
  const std::string metrics = page.answer().value_or(HttpAnswer{}).body;
  EXPECT_NE(metrics.find("selvage_calls_total{method=\"engine.info\",code=\"0\"} 2\n"), std::string::npos) << metrics;
  EXPECT_NE(metrics.find("selvage_open_connections{speaks=\"lines\"} 2\n"), std::string::npos) << metrics;
  EXPECT_NE(metrics.find("selvage_open_markers 0\n"), std::string::npos) << metrics;
  selvaged.signal(SIGTERM);
  EXPECT_EQ(selvaged.exit_code(), 0);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_F(Selvaged, ReopensItsLogOnSighup) {
  const std::string log = folder_.file("log");
  Process selvaged{arguments({"--log", log})};
  Wire wire{port_of(selvaged)};
  ASSERT_FALSE(post_call(wire, "engine.info").empty());
  std::filesystem::rename(log, log + ".1");
  selvaged.signal(SIGHUP);
  const auto patience = std::chrono::steady_clock::now() + kPatience;
  while (file_text(log).empty() && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
  ASSERT_FALSE(post_call(wire, "marker.list").empty());
  selvaged.signal(SIGTERM);
  EXPECT_EQ(selvaged.exit_code(), 0);
  EXPECT_NE(file_text(log + ".1").find("engine.info"), std::string::npos);
  EXPECT_EQ(file_text(log + ".1").find("marker.list"), std::string::npos);
  EXPECT_NE(file_text(log).find("marker.list"), std::string::npos);
  EXPECT_NE(file_text(log).find("drained"), std::string::npos);
}

TEST_F(Selvaged, ReadsItsTokenAgainOnSighup) {
  const std::string token = folder_.file("token");
  std::ofstream{token} << "correct horse battery\n";
  Process selvaged{arguments({"--token-file", token})};
  const std::uint16_t port = port_of(selvaged);
  const auto status = [port](const std::string& with) {
    Wire wire{port};
    wire.send(post_request("{}", "Authorization: Bearer " + with + "\r\n"));
    return wire.answer().value_or(HttpAnswer{}).status;
  };
  std::ofstream{token} << "short\n";
  selvaged.signal(SIGHUP);
  EXPECT_NE(selvaged.output_until("is too short").find("in use are kept"), std::string::npos);
  EXPECT_EQ(status("correct horse battery"), 200);
  std::ofstream{token} << "different horse staple\n";
  selvaged.signal(SIGHUP);
  EXPECT_NE(selvaged.output_until("have been read again").find("have been read again"), std::string::npos);
  EXPECT_EQ(status("correct horse battery"), 401);
  EXPECT_EQ(status("different horse staple"), 200);
}

TEST_F(Selvaged, ChecksItsConfigurationWithoutServing) {
  Process sound{{SELVAGED, "--check-config"}};
  EXPECT_EQ(sound.exit_code(), 0);
  Process no_key{{SELVAGED, "--check-config", "--tls-cert", "nowhere.pem", "--tls-key", "nowhere.pem"}};
  EXPECT_NE(no_key.all_output().find("nowhere.pem"), std::string::npos);
  EXPECT_EQ(no_key.exit_code(), 2);
  const std::string nowhere = folder_.file("nowhere/file");
  for (const char* option : {"--store", "--log", "--port-file"}) {
    Process no_folder{{SELVAGED, "--check-config", option, nowhere}};
    EXPECT_NE(no_folder.all_output().find(std::string{option} + " " + nowhere), std::string::npos) << option;
    EXPECT_EQ(no_folder.exit_code(), 2) << option;
    EXPECT_FALSE(std::filesystem::exists(folder_.file("nowhere"))) << option;
  }
  const std::string store = folder_.file("store");
  Process good{{SELVAGED, "--check-config", "--store", store, "--log", folder_.file("log")}};
  EXPECT_EQ(good.exit_code(), 0);
  EXPECT_FALSE(std::filesystem::exists(store));
}

TEST_F(Selvaged, NamesTheStoreThatItCannotOpen) {
  const std::string nowhere = folder_.file("nowhere/file");
  Process selvaged{{SELVAGED, "--listen", "127.0.0.1:0", "--store", nowhere}};
  EXPECT_NE(selvaged.all_output().find("--store " + nowhere), std::string::npos);
  EXPECT_EQ(selvaged.exit_code(), 1);
}

TEST_F(Selvaged, AnswersTheCallsOfAFileWithoutSockets) {
  const std::string calls = folder_.file("calls.json");
  const std::string drawing = folder_.file("out.svg");
  std::ofstream{calls} << "[" << call(1, "marker.open", open_params(garment("jeans_02g"))) << ","
                       << call(2, "motion.compact", id_params("m1", R"(,"accuracy":"draft")")) << "]";
  Process selvaged{{SELVAGED, "--check", calls, "--svg", drawing, "--log-level", "off"}};
  std::istringstream answers{selvaged.all_output()};
  EXPECT_EQ(selvaged.exit_code(), 0);
  std::string opened;
  std::string compacted;
  ASSERT_TRUE(std::getline(answers, opened) && std::getline(answers, compacted));
  EXPECT_LT(result_of(compacted)["lengthAfter"], result_of(opened)["length"]);
  EXPECT_EQ(file_text(drawing).rfind("<svg", 0), 0U);

  std::ofstream{calls} << call(1, "no.such.method");
  Process failing{{SELVAGED, "--check", calls, "--log-level", "off"}};
  EXPECT_NE(failing.all_output().find("-32601"), std::string::npos);
  EXPECT_EQ(failing.exit_code(), 1);
}

TEST_F(Selvaged, ServesTheCurlExample) {
  Process selvaged{arguments()};
  ::setenv("SELVAGED", ("127.0.0.1:" + std::to_string(port_of(selvaged))).c_str(), 1);
  const std::string outlines = folder_.file("outlines.json");
  Process script{
      {repository_path("examples/curl/compact.sh"), repository_path("examples/markers/jeans_02g.json"), outlines}};
  const std::string output = script.all_output();
  EXPECT_EQ(script.exit_code(), 0) << output;
  EXPECT_NE(output.find("length 2460.35 -> "), std::string::npos) << output;
  const Json saved = Json::parse(file_text(outlines));
  EXPECT_EQ(saved["pieces"].size(), 40U);
  EXPECT_LT(saved["strip_length"], 2460.35);

  Process missing{{repository_path("examples/curl/compact.sh"), repository_path("README.md"), outlines}};
  EXPECT_NE(missing.all_output().find("selvaged: "), std::string::npos);
  EXPECT_NE(missing.exit_code(), 0);
}

}  // namespace
}  // namespace selvage::test
