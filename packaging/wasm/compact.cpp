// The program of the WebAssembly build: compacts the marker of its standard input, and writes it to its standard
// output. Exits with 1 and a message when the marker cannot be read or compacted.
#include <cstdio>
#include <iostream>
#include <iterator>
#include <string>

#include "core/marker/validity.h"
#include "core/motion/compaction/compact.h"
#include "protocol/formats/format.h"

namespace {

int refused(const selvage::Error& error) {
  std::fprintf(stderr, "%s: %s\n", error.field.c_str(), error.message.c_str());
  return 1;
}

}  // namespace

int main() {
  using namespace selvage;  // NOLINT(google-build-using-namespace)
  const std::string text{std::istreambuf_iterator<char>{std::cin}, {}};
  auto file = protocol::formats::read_marker(text);
  if (!file) return refused(file.error());
  SumCache sums;
  const auto settings = compaction_settings(motion::compaction::Accuracy::kStandard);
  auto result = compact(file->marker, settings, {sums});
  if (!result) return refused(result.error());
  const auto length = [&](Coord coordinate) { return to_decimal(coordinate, file->marker.resolution); };
  std::fprintf(stderr, "%zu pieces: %.6f -> %.6f in %d rounds, %s\n", file->marker.pieces.size(),
               length(result->length_before), length(result->length_after), result->rounds,
               is_valid(result->marker) ? "valid" : "not valid");
  file->marker = std::move(result->marker);
  const auto written = protocol::formats::write_marker(*file, file->format);
  if (!written) return refused(written.error());
  std::cout << *written;
}
