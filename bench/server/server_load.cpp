// Measures how fast a running selvaged answers: calls per second and latencies, for one or more clients.
//
// usage: server_load PORT MARKER get|bump|compact|place|push [CONNECTIONS] [SECONDS]
//   get: POST /rpc marker.get on a persistent connection
//   bump: motion.bump without commit, for one piece after another, over a WebSocket
//   compact: motion.compact without commit, over a WebSocket
//   place: drag.move over a WebSocket, in small steps around each piece in turn
//   push: the same with other pieces making way
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "tests/server/wire/websocket_wire.h"
#include "tests/server/wire/wire.h"

namespace selvage::bench {
namespace {

using Json = nlohmann::ordered_json;

using Clock = std::chrono::steady_clock;
using test::WebSocketWire;
using test::Wire;

std::string call(const std::string& method, const Json& params) {
  return Json{{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", params}}.dump();
}

Json ask(WebSocketWire& wire, const std::string& method, const Json& params) {
  wire.send_text(call(method, params));
  const Json answer = Json::parse(wire.text().value_or("{}"));
  if (!answer.contains("result")) throw std::runtime_error{method + ": " + answer.dump()};
  return answer["result"];
}

struct Load {
  std::uint16_t port{};
  std::string what;
  std::string marker_id;
  Json pieces;
};

// The milliseconds of each call until the end time.
std::vector<double> run(const Load& load, std::size_t first_piece, Clock::time_point end) {
  std::vector<double> times;
  Wire http{load.port};
  WebSocketWire wire{load.port};
  const auto timed = [&](const auto& work) {
    const auto began = Clock::now();
    work();
    times.push_back(std::chrono::duration<double, std::milli>{Clock::now() - began}.count());
  };
  const std::string get = test::post_request(call("marker.get", {{"markerId", load.marker_id}}));
  for (std::size_t k = first_piece; Clock::now() < end; ++k) {
    const Json& piece = load.pieces[k % load.pieces.size()];
    if (load.what == "get") {
      timed([&] {
        http.send(get);
        if (http.answer().value_or(test::HttpAnswer{}).status != 200) throw std::runtime_error{"no answer"};
      });
    } else if (load.what == "compact") {
      timed([&] { (void)ask(wire, "motion.compact", {{"markerId", load.marker_id}, {"commit", false}}); });
    } else if (load.what == "bump") {
      const double turn = static_cast<double>(k);
      const Json params{{"markerId", load.marker_id},
                        {"piece", piece["id"]},
                        {"direction", {std::cos(turn), std::sin(turn)}},
                        {"commit", false}};
      timed([&] { (void)ask(wire, "motion.bump", params); });
    } else {
      const Json begun =
          ask(wire, "drag.begin", {{"markerId", load.marker_id}, {"piece", piece["id"]}, {"mode", load.what}});
      const double x = piece["at"][0], y = piece["at"][1];
      for (int step = 1; step <= 20 && Clock::now() < end; ++step) {
        const Json to{x + 2.0 * step, y + 10 * std::sin(step)};
        timed([&] { (void)ask(wire, "drag.move", {{"dragId", begun["dragId"]}, {"to", to}}); });
      }
      (void)ask(wire, "drag.end", {{"dragId", begun["dragId"]}, {"markerId", load.marker_id}, {"commit", false}});
    }
  }
  return times;
}

void print_summary(const Load& load, std::vector<double> times, std::size_t connections, double seconds) {
  std::sort(times.begin(), times.end());
  const auto part = [&](double p) {
    return times[std::min(times.size() - 1, static_cast<std::size_t>(p * static_cast<double>(times.size())))];
  };
  std::printf("%s: %zu connections, %.1f s, %zu calls, %.0f per second; ms p50 %.3f, p99 %.3f, max %.3f\n",
              load.what.c_str(), connections, seconds, times.size(), static_cast<double>(times.size()) / seconds,
              part(0.5), part(0.99), times.back());
}

int measure(const std::vector<std::string>& words) {
  const auto port = static_cast<std::uint16_t>(std::stoi(words.at(0)));
  std::ostringstream document;
  document << std::ifstream{words.at(1)}.rdbuf();
  const std::size_t connections = words.size() > 3 ? std::stoul(words[3]) : 1;
  const double seconds = words.size() > 4 ? std::stod(words[4]) : 5;
  WebSocketWire wire{port};
  const Json opened = ask(wire, "marker.open", {{"marker", Json::parse(document.str())}});
  const std::string id = opened["markerId"];
  const Load load{port, words.at(2), id, ask(wire, "marker.get", {{"markerId", id}})["marker"]["pieces"]};
  std::vector<std::vector<double>> times(connections);
  {
    const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>{seconds});
    std::vector<std::jthread> clients;
    for (std::size_t k = 0; k < connections; ++k) {
      clients.emplace_back([&, k] { times[k] = run(load, k * 7, end); });
    }
  }
  std::vector<double> all;
  for (const auto& one : times) all.insert(all.end(), one.begin(), one.end());
  if (all.empty()) throw std::runtime_error{"no call was answered"};
  print_summary(load, std::move(all), connections, seconds);
  (void)ask(wire, "marker.close", {{"markerId", id}});
  return 0;
}

}  // namespace
}  // namespace selvage::bench

int main(int argc, char** argv) {
  try {
    return selvage::bench::measure({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(
        stderr, "server_load: %s\nusage: server_load PORT MARKER get|bump|compact|place|push [CONNECTIONS] [SECONDS]\n",
        error.what());
    return 2;
  }
}
