// Compares the weights with the memory that the allocator provides.
#include "server/memory/weights.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <memory>
#include <string>

#include "core/minkowski/cache.h"
#include "core/scene/laid_out.h"
#include "protocol/formats/format.h"
#include "protocol/formats/native.h"
#include "tests/support/repository.h"

namespace selvage::server::memory {
namespace {

using test::garment_text;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMeasured = false;  // a sanitizer's allocator does not report it
#elif defined(__has_feature)       // the spelling in clang
constexpr bool kMeasured = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool kMeasured = true;
#endif

std::size_t allocated() {
  const auto info = ::mallinfo2();
  return info.uordblks + info.hblkhd;
}

// The memory of a value that `make` returns, without the value itself.
template <class Make>
std::size_t measured(const Make& make) {
  const std::size_t before = allocated();
  const auto made = make();
  return allocated() - before;
}

void expect_near(std::size_t weight, std::size_t actual, const std::string& of) {
  if (!kMeasured) return;
  EXPECT_GE(static_cast<double>(weight), 0.8 * static_cast<double>(actual)) << of;
  EXPECT_LE(static_cast<double>(weight), 1.5 * static_cast<double>(actual)) << of;
}

TEST(Weights, AMarkerWeighsWhatTheAllocatorHandsOut) {
  for (const char* name : {"jeans_02g", "jeans_22g"}) {
    const std::string text = garment_text(name);
    const auto read = [&text] { return *protocol::formats::read_marker(text); };
    const std::size_t weight = bytes_of(read());  // the first reading also makes what every reading needs
    expect_near(weight, measured(read), name);
  }
}

TEST(Weights, AttributesCount) {
  MarkerFile file = *protocol::formats::read_marker(garment_text("jeans_02g"));
  const std::size_t without = bytes_of(file);
  Json list = Json::array(std::size_t{100'000});
  for (Json& element : list) element = Json("a text of more than a few characters");
  file.attributes.whole["notes"] = list;
  expect_near(bytes_of(file) - without, measured([&] { return list; }), "a list of texts");
  EXPECT_GT(bytes_of(file) - without, 7'000'000U);
}

TEST(Weights, ReadersAreCountedWithTheirTextAndTheirLaidOutForm) {
  for (const char* name : {"jeans_02g", "jeans_22g"}) {
    const MarkerFile file = *protocol::formats::read_marker(garment_text(name));
    const std::size_t text = protocol::json::to_text(protocol::formats::native_document(file)).size();
    SumCache sums{std::size_t{64} << 20};
    (void)scene::outlines_of(file.marker, sums);  // the cache's own
    const std::size_t laid_out = measured([&] { return std::make_unique<scene::LaidOut>(file.marker, sums); });
    if (!kMeasured) continue;
    EXPECT_GE(bytes_for_readers(file), (text + laid_out) * 7 / 10) << name << " " << text << " " << laid_out;
    EXPECT_LE(bytes_for_readers(file), (text + laid_out) * 3) << name << " " << text << " " << laid_out;
  }
}

TEST(Weights, MovesWeighTheirPieces) {
  const MarkerFile file = *protocol::formats::read_marker(garment_text("jeans_22g"));
  protocol::edits::Moves moves;
  for (std::uint32_t k = 0; k < file.marker.pieces.size(); ++k) moves.push_back({k, file.marker.pieces[k]});
  expect_near(bytes_of(moves), measured([&] { return moves; }), "moves");
}

TEST(Weights, NoMessageTakesMoreToReadThanItsBound) {
  std::string many_fields = "[";
  for (int k = 0; k < 5000; ++k) {
    many_fields += std::string{k == 0 ? "" : ","} + R"({"a field of some length":"x","b":{},"c":[],"d":[[1]]})";
  }
  for (const std::string& text :
       {garment_text("jeans_22g"), many_fields + "]", std::string(30'000, '[').substr(0, 60) + std::string(60, ']'),
        "[" + std::string(100'000, ' ') + "]", std::string{"[null"} + std::string(0, ' ') + "]",
        "\"" + std::string(100'000, 'x') + "\"", std::string{"17"}}) {
    const auto parsed = protocol::json::parse(text);
    ASSERT_TRUE(parsed) << text.substr(0, 40);
    EXPECT_GE(bytes_to_read(text) + 64, bytes_of(*parsed)) << text.substr(0, 40);
    if (!kMeasured) continue;
    const std::size_t actual = measured([&] { return protocol::json::parse(text); });
    EXPECT_GE(bytes_to_read(text) + 64, actual) << text.substr(0, 40);
  }
}

}  // namespace
}  // namespace selvage::server::memory
