// A minimal C++ client of a daemon: opens a marker, compacts it, prints its length before and after, and closes it.
//   example_compact ADDRESS MARKER.json
#include <fstream>
#include <iostream>

#include "clients/cpp/client.h"

int main(int argc, char** argv) {
  using namespace selvage::client;  // NOLINT(google-build-using-namespace)
  if (argc != 3) return std::cerr << "usage: example_compact ADDRESS MARKER.json\n", 2;
  Client client{argv[1]};
  std::ifstream file{argv[2]};
  const Answer opened = client.call("marker.open", {{"marker", Json::parse(file, nullptr, false)}});
  if (!opened) return std::cerr << opened.error().message << "\n", 1;
  const Json& id = (*opened)["markerId"];
  const Answer compacted = client.call("motion.compact", {{"markerId", id}});
  if (!compacted) return std::cerr << compacted.error().message << "\n", 1;
  std::cout << (*compacted)["lengthBefore"] << " -> " << (*compacted)["lengthAfter"] << "\n";
  return client.call("marker.close", {{"markerId", id}}) ? 0 : 1;
}
