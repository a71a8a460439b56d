#include "tests/trials/memory/greedy_clients.h"
#include "tests/trials/live/error_codes.h"

#include <chrono>
#include <cstddef>
#include <exception>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tests/trials/live/caller.h"

namespace selvage::trials {
namespace {

using namespace std::chrono_literals;

// The example marker in the native form.  Waits for room, which there may not be until the daemon has freed what
// connections held that have just ended.
Json native_marker(Caller& caller) {
  const Json params{{"marker", Json::parse(garment("jeans_06g"))}};
  Json opened = caller.ask("marker.open", params);
  for (int tries = 0; code_of(opened) == kNoRoom && tries < 500; ++tries) {
    std::this_thread::sleep_for(10ms);
    opened = caller.ask("marker.open", params);
  }
  const Json id = opened.at("result").at("markerId");
  Json marker = caller.result("marker.get", {{"markerId", id}})["marker"];
  (void)caller.result("marker.close", {{"markerId", id}});
  return marker;
}

// The same document with a note of this many bytes, which marker.get returns, too.
Json marker_with_note(Caller& caller, std::size_t bytes) {
  Json marker = native_marker(caller);
  marker["attributes"]["note"] = std::string(bytes, 'x');
  return marker;
}

std::string open_marker(Caller& caller, const Json& marker, Greed& greed, Faults& faults) {
  const Json answer = caller.ask("marker.open", {{"marker", marker}});
  greed.count(code_of(answer), faults);
  return code_of(answer) == 0 ? answer["result"]["markerId"].get<std::string>() : std::string{};
}

// Whole earlier markers in the undo history: 60 changes of the strip of a marker of 4 MB.
void history(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller caller{daemon, Endpoint::kTcp};
  const Json marker = marker_with_note(caller, 4'000'000);
  const std::string id = open_marker(caller, marker, greed, faults);
  if (id.empty()) return;
  for (int k = 1; k <= 60; ++k) {
    const Json widened{{"op", "setStrip"}, {"width", marker["strip"]["width"].get<double>() + k}};
    greed.count(code_of(caller.ask("marker.apply", {{"markerId", id}, {"ops", Json::array({widened})}})), faults);
  }
  (void)caller.ask("marker.close", {{"markerId", id}});
}

// Answers of batches that are not read: 16 batches of 100 calls of marker.get, of a marker of 1 MB.
void batches(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller owner{daemon, Endpoint::kTcp};
  const std::string id = open_marker(owner, marker_with_note(owner, 1'000'000), greed, faults);
  if (id.empty()) return;
  std::string batch;
  for (int k = 0; k < 100; ++k) batch += (k == 0 ? "[" : ",") + call_text(k, "marker.get", {{"markerId", id}});
  std::vector<std::unique_ptr<Caller>> callers;
  for (int k = 0; k < 16; ++k) {
    callers.push_back(std::make_unique<Caller>(daemon, Endpoint::kTcp));
    callers.back()->send_text(batch + "]");
  }
  std::this_thread::sleep_for(1s);
  for (const auto& caller : callers) {
    const auto text = caller->next_text();
    if (!text) {
      ++greed.hangups;
      continue;
    }
    for (const Json& answer : Json::parse(*text)) greed.count(code_of(answer), faults);
  }
  (void)owner.ask("marker.close", {{"markerId", id}});
}

// Large requests in flight: 24 openings of markers of 30 MB on one connection, one after another without waiting.
void requests(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller caller{daemon, Endpoint::kTcp};
  const std::string text = call_text(1, "marker.open", {{"marker", marker_with_note(caller, 30'000'000)}});
  constexpr int kCalls = 24;
  std::jthread sender{[&] {
    try {
      for (int k = 0; k < kCalls; ++k) caller.send_text(text);
    } catch (const std::exception&) {  // the daemon has disconnected, which is counted below
    }
  }};
  std::vector<std::string> opened;
  for (int k = 0; k < kCalls; ++k) {
    const auto answer = caller.next_text();
    if (!answer) {
      ++greed.hangups;
      break;
    }
    const Json message = Json::parse(*answer);
    greed.count(code_of(message), faults);
    if (code_of(message) == 0) opened.push_back(message["result"]["markerId"]);
  }
  sender.join();
  Caller closing{daemon, Endpoint::kTcp};
  for (const std::string& id : opened) (void)closing.ask("marker.close", {{"markerId", id}});
}

// Messages of millions of small values, which take far more memory than their bytes, from 8 connections.
void values(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  std::string list = "[0";
  for (int k = 0; k < 1'000'000; ++k) list += ",[]";
  const std::string text = R"({"jsonrpc":"2.0","id":1,"method":"marker.open","params":{"marker":)" + list + "]}}";
  std::vector<std::jthread> threads;
  for (int k = 0; k < 8; ++k) {
    threads.emplace_back([&] {
      faults.guard("a message of many values", [&] {
        Caller caller{daemon, Endpoint::kTcp};
        for (int i = 0; i < 4; ++i) caller.send_text(text);
        for (int i = 0; i < 4; ++i) {
          const auto answer = caller.next_text();
          if (!answer) return void(++greed.hangups);
          ++greed.refusals;  // it is not a marker
        }
      });
    });
  }
}

// Answers kept for retries: calls with an opId on separate markers, whose answers name 120 pieces.
void answers(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller caller{daemon, Endpoint::kTcp};
  const Json marker = native_marker(caller);
  std::vector<std::string> ids;
  for (int k = 0; k < 20; ++k) {
    const std::string id = open_marker(caller, marker, greed, faults);
    if (id.empty()) break;
    ids.push_back(id);
    for (int i = 0; i < 100; ++i) {
      Json edits = Json::array();
      for (const Json& piece : marker["pieces"]) {
        edits.push_back({{"op", "move"}, {"piece", piece["id"]}, {"at", {i, i}}});
      }
      const Json params{{"markerId", id}, {"opId", std::to_string(i)}, {"ops", edits}};
      greed.count(code_of(caller.ask("marker.apply", params)), faults);
    }
  }
  for (const std::string& id : ids) (void)caller.ask("marker.close", {{"markerId", id}});
}

// Markers: small ones until one is refused, at most 20,000.
void markers(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller caller{daemon, Endpoint::kTcp};
  const std::string text = call_text(1, "marker.open", {{"marker", Json::parse(garment("jeans_02g"))}});
  std::vector<std::string> ids;
  for (int code = 0; code == 0 && ids.size() < 20'000;) {
    caller.send_text(text);
    const Json answer = caller.next_answer();
    code = code_of(answer);
    greed.count(code, faults);
    if (code == 0) ids.push_back(answer["result"]["markerId"]);
  }
  for (const std::string& id : ids) (void)caller.ask("marker.close", {{"markerId", id}});
}

// Drag sessions on revisions that have been replaced: 16 of a marker of 1 MB on each of 8 connections.
void drag_sessions(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller owner{daemon, Endpoint::kTcp};
  const Json marker = marker_with_note(owner, 1'000'000);
  const std::string id = open_marker(owner, marker, greed, faults);
  if (id.empty()) return;
  const Json piece = marker["pieces"][0]["id"];
  std::vector<std::unique_ptr<Caller>> callers;
  for (int k = 0; k < 8 * 16; ++k) {
    if (k % 16 == 0) callers.push_back(std::make_unique<Caller>(daemon, Endpoint::kTcp));
    greed.count(code_of(callers.back()->ask("drag.begin", {{"markerId", id}, {"piece", piece}})), faults);
    const Json widened{{"op", "setStrip"}, {"width", marker["strip"]["width"].get<double>() + k}};
    greed.count(code_of(owner.ask("marker.apply", {{"markerId", id}, {"ops", Json::array({widened})}})), faults);
  }
  (void)owner.ask("marker.close", {{"markerId", id}});
}

// Notifications that are not read: 32 watchers of a marker of 1 MB whose strip changes 60 times.
void watchers(const LiveDaemon& daemon, Greed& greed, Faults& faults) {
  Caller owner{daemon, Endpoint::kTcp};
  const Json marker = marker_with_note(owner, 1'000'000);
  const std::string id = open_marker(owner, marker, greed, faults);
  if (id.empty()) return;
  std::vector<std::unique_ptr<Caller>> callers;
  for (int k = 0; k < 32; ++k) {
    callers.push_back(std::make_unique<Caller>(daemon, Endpoint::kWebSocket));
    (void)callers.back()->ask("marker.watch", {{"markerId", id}});
  }
  for (int k = 1; k <= 60; ++k) {
    const Json widened{{"op", "setStrip"}, {"width", marker["strip"]["width"].get<double>() + k}};
    greed.count(code_of(owner.ask("marker.apply", {{"markerId", id}, {"ops", Json::array({widened})}})), faults);
  }
  (void)owner.ask("marker.close", {{"markerId", id}});
}

}  // namespace

void Greed::count(int code, Faults& faults) {
  if (code == 0) {
    ++results;
  } else {
    ++refusals;
    faults.expect(code == kNoRoom || code == kBusy || code == kTooLarge, "answered " + std::to_string(code));
  }
}

const std::vector<GreedyClient>& greedy_clients() {
  static const std::vector<GreedyClient> kAll{
      {"history", history},      {"batches", batches}, {"requests", requests},   {"values", values},
      {"kept answers", answers}, {"markers", markers}, {"drags", drag_sessions}, {"watchers", watchers}};
  return kAll;
}

}  // namespace selvage::trials
