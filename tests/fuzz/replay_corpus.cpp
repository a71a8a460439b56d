// The main function of a fuzz target that is not linked with libFuzzer: runs the target on every file of the given
// folders.
//
// usage: fuzz_TARGET FOLDER...
// exit status 0: all inputs passed; 2: there are no inputs
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

#include "tests/fuzz/entry.h"

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> files;
  for (int k = 1; k < argc; ++k) {
    for (const auto& entry : std::filesystem::directory_iterator{argv[k]}) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    std::cout << file.filename().string() << std::endl;
    std::ifstream stream{file, std::ios::binary};
    const std::vector<char> text{std::istreambuf_iterator<char>{stream}, {}};
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
  }
  return files.empty() ? 2 : 0;
}
