#include "tests/pins/pins.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <map>

#include "tests/support/repository.h"

namespace selvage::test {
namespace {

using Figures = std::map<std::string, double>;

std::string path_of(const std::string& file) {
  return repository_path("tests/pins/" + file + ".txt");
}

// A line is the key, which may contain blanks, a colon and the figure.
Figures read(const std::string& file) {
  Figures figures;
  std::ifstream in{path_of(file)};
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.rfind(": ");
    if (colon != std::string::npos) figures[line.substr(0, colon)] = std::stod(line.substr(colon + 2));
  }
  return figures;
}

Figures& figures_of(const std::string& file) {
  static std::map<std::string, Figures> files;
  const auto found = files.find(file);
  return found != files.end() ? found->second : files[file] = read(file);
}

void record(const std::string& file, const std::string& key, double measured) {
  Figures& figures = figures_of(file);
  figures[key] = measured;
  std::ofstream out{path_of(file)};
  out << std::setprecision(6);
  for (const auto& [name, figure] : figures) {
    out << name << ": ";
    if (figure == std::floor(figure)) {
      out << static_cast<long long>(figure) << '\n';
    } else {
      out << figure << '\n';
    }
  }
}

}  // namespace

void expect_pinned(const std::string& file, const std::string& key, double measured, double slack) {
  if (std::getenv("SELVAGE_RECORD_PINS")) return record(file, key, measured);
  const Figures& figures = figures_of(file);
  const auto pin = figures.find(key);
  ASSERT_TRUE(pin != figures.end()) << key << " is not in tests/pins/" << file << ".txt: run ./dev pins";
  EXPECT_LE(measured, pin->second * (1 + slack)) << key << ": if this is intended, run ./dev pins";
}

}  // namespace selvage::test
