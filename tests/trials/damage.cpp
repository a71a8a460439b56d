#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tests/trials/live/caller.h"
#include "tests/trials/live/live_daemon.h"
#include "tests/trials/trials.h"

namespace selvage::trials {
namespace {

constexpr int kMarkers = 5, kChanges = 12;

std::string bytes_of(const std::string& path) {
  std::ostringstream bytes;
  bytes << std::ifstream{path, std::ios::binary}.rdbuf();
  return bytes.str();
}

// The content of the store as a client sees it: the document of each marker, the documents that undo leads back to, and
// the answers to retries.
struct Content {
  std::vector<std::string> markers;
  std::string list;
};

Json edit(int marker, int number) {
  return {{"markerId", "m" + std::to_string(marker)},
          {"opId", "op" + std::to_string(number)},
          {"ops", {{{"op", "setSpacing"}, {"spacing", 0.125 * (number % 3)}}, {{"op", "lock"}, {"piece", "low"}}}}};
}

constexpr const char* kDocument =
    R"({"format":"selvage-marker","version":1,"name":"NAME","strip":{"width":10},)"
    R"("shapes":[{"id":"square","outline":[[0,0],[2,0],[2,2],[0,2]]}],)"
    R"("pieces":[{"id":"low","shape":"square","at":[3,0]},{"id":"high","shape":"square","at":[3,4]}]})";

void fill(const std::string& store) {
  LiveDaemon daemon{{"--store", store, "--durability", "relaxed"}};
  Caller caller{daemon, Endpoint::kTcp};
  for (int m = 1; m <= kMarkers; ++m) {
    Json document = Json::parse(kDocument);
    document["name"] = "marker " + std::to_string(m);
    (void)caller.result("marker.open", {{"marker", document}, {"opId", "open" + std::to_string(m)}});
    for (int n = 0; n < kChanges; ++n) (void)caller.ask("marker.apply", edit(m, n));
    for (int n = 0; n < kChanges; ++n) {
      (void)caller.ask(
          "marker.apply",
          {{"markerId", "m" + std::to_string(m)},
           {"ops",
            {{{"op", "unlock"}, {"piece", "low"}}, {{"op", "move"}, {"piece", "low"}, {"at", {4 + 0.25 * n, 0}}}}}});
    }
  }
  if (daemon.end() != 0) throw std::runtime_error{"selvaged did not end by itself"};
}

// The answer without the id of the call, which depends on how many calls there were before.
std::string text_of(Json answer) {
  answer.erase("id");
  return answer.dump();
}

Content content_of(const LiveDaemon& daemon) {
  Caller caller{daemon, Endpoint::kTcp};
  Content content{{}, text_of(caller.ask("marker.list"))};
  for (int m = 1; m <= kMarkers; ++m) {
    const Json id{{"markerId", "m" + std::to_string(m)}};
    std::string seen = text_of(caller.ask("marker.get", id));
    if (seen.find("\"error\"") != std::string::npos) {
      content.markers.push_back("refused");
      continue;
    }
    for (int n = 0; n < kChanges; n += 5) seen += text_of(caller.ask("marker.apply", edit(m, n)));  // retries
    for (int n = 0; n < 2 * kChanges; ++n) {
      (void)caller.ask("marker.undo", id);
      seen += caller.ask("marker.get", id)["result"]["marker"].dump();
    }
    content.markers.push_back(seen);
  }
  return content;
}

struct Counts {
  std::size_t same{}, refused{}, quarantined{}, reported{};
};

// Starts a daemon on the damaged store.  It must serve the same content as before, or report the damage.
void judge(const std::string& store, const Content& sound, const std::string& what, Counts& counts, Faults& faults) {
  std::optional<LiveDaemon> daemon;
  try {
    daemon.emplace(std::vector<std::string>{"--store", store, "--durability", "relaxed"});
  } catch (const std::exception&) {
    ++counts.refused;
    return;
  }
  const Content found = content_of(*daemon);
  (void)daemon->end();  // the log is complete now
  const std::string log = daemon->log_text();
  const bool reported =
      log.find("the store is damaged") != std::string::npos || log.find("cannot be read") != std::string::npos;
  bool differs = found.list != sound.list;
  for (std::size_t m = 0; m < found.markers.size(); ++m) {
    if (found.markers[m] == sound.markers[m]) continue;
    differs = true;
    faults.expect(found.markers[m] == "refused", what + ": marker " + std::to_string(m + 1) + " differs and is served");
  }
  faults.expect(!differs || reported, what + ": the content differs and nothing is reported");
  if (!differs) ++(reported ? counts.reported : counts.same);
  if (differs) ++counts.quarantined;
}

}  // namespace

void damage(std::size_t count, Faults& faults) {
  const test::TemporaryFolder folder;
  const std::string store = folder.file("store"), damaged = folder.file("damaged");
  fill(store);
  const std::string bytes = bytes_of(store);
  const auto copy = [&](const std::string& content) {
    std::filesystem::remove(damaged + "-wal");
    std::filesystem::remove(damaged + "-shm");
    std::ofstream{damaged, std::ios::binary} << content;
  };
  copy(bytes);
  Content sound;
  {
    LiveDaemon daemon{{"--store", damaged}};
    sound = content_of(daemon);
    (void)daemon.end();
  }
  Counts counts;
  std::mt19937_64 random{20'26};
  for (std::size_t k = 0; k < count; ++k) {
    std::string changed = bytes;
    const std::size_t at = random() % bytes.size();
    const auto bit = static_cast<unsigned>(random() % 8);
    const bool truncate = k % 10 == 9;
    if (truncate) {
      changed.resize(at);
    } else {
      changed[at] = static_cast<char>(changed[at] ^ (1U << bit));
    }
    copy(changed);
    judge(damaged, sound, (truncate ? "truncated at " : "a flipped bit at ") + std::to_string(at), counts, faults);
  }
  std::printf(
      "%zu damaged copies of a store of %zu bytes: %zu refused, %zu with quarantined markers, %zu unchanged but "
      "reported, %zu unchanged (free or unused bytes)\n",
      count, bytes.size(), counts.refused, counts.quarantined, counts.reported, counts.same);
}

}  // namespace selvage::trials
