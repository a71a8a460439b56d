#include "tests/support/repository.h"

#include <fstream>
#include <iterator>
#include <stdexcept>

namespace selvage::test {

std::string repository_path(const std::string& path) {
  return std::string{SELVAGE_SOURCE_DIR} + "/" + path;
}

std::string repository_text(const std::string& path) {
  std::ifstream file{repository_path(path), std::ios::binary};
  if (!file) throw std::runtime_error{"cannot read " + repository_path(path)};
  return {std::istreambuf_iterator<char>{file}, {}};
}

std::string garment_text(const std::string& name) {
  return repository_text("examples/markers/" + name + ".json");
}

}  // namespace selvage::test
