#include "tests/trials/malformed/malformed_messages.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "tests/support/repository.h"

namespace selvage::trials {
namespace {

using test::Random;

// As text, because some are not valid JSON and others are beyond the range of double.
constexpr std::array kOddNumbers{
    "NaN",
    "-NaN",
    "Infinity",
    "-Infinity",
    "1e308",
    "-1e308",
    "1e309",
    "1e400",
    "1e999999999999",
    "-1e-999999999999",
    "1e-400",
    "5e-324",
    "9007199254740993",
    "-9007199254740993",
    "18446744073709551616",
    "-9223372036854775809",
    "9223372036854775807",
    "4294967296",
    "2147483648",
    "-0",
    "-0.0",
    "0e0",
    "00",
    "0x10",
    "1.",
    ".5",
    "+1",
    "1e",
    "-",
    "1_000",
    "1,5",
    "2.7",
    "-1",
};
constexpr std::array kOddValues{"null", "true",        "false",       "[]",      "{}",     "[[]]",
                                "\"\"", "\"\\u0000\"", "\"\\ud800\"", "\"m1\"",  "[null]", "{\"a\":{}}",
                                "0",    "-1",          "1e308",       "[1,2,3]", "\"NaN\""};
constexpr std::string_view kPlaceholder = "\"\\u0001odd\\u0001\"";

std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

void collect(Json& value, bool numbers_only, std::vector<Json*>& found) {
  if (value.is_structured()) {
    for (Json& inner : value) collect(inner, numbers_only, found);
  }
  if (value.is_number() || !numbers_only) found.push_back(&value);
}

// The request with one of its values replaced by the text `odd`; unchanged if it has no values.
std::string with(Json request, bool numbers_only, Random& random, std::string_view odd) {
  std::vector<Json*> places;
  collect(request, numbers_only, places);
  if (places.empty()) return request.dump();
  *places[random.below(places.size())] = "\x01odd\x01";
  return replaced(request.dump(), kPlaceholder, odd);
}

// Whether the daemon must answer this line.
bool owes_answer(const std::string& text) {
  if (text.find_first_not_of(" \t\r") == std::string::npos) return false;
  const Json message = Json::parse(text, nullptr, false);
  if (message.is_object()) return message.contains("id");
  if (!message.is_array() || message.empty()) return true;
  return !std::all_of(message.begin(), message.end(),
                      [](const Json& call) { return call.is_object() && !call.contains("id"); });
}

std::string nested(std::string_view open, std::string_view close, std::size_t depth) {
  std::string text;
  text.reserve(depth * (open.size() + close.size()));
  for (std::size_t k = 0; k < depth; ++k) text += open;
  for (std::size_t k = 0; k < depth; ++k) text += close;
  return text;
}

// A call of exactly `size` bytes.
std::string long_call(std::size_t size, std::string_view before, std::string_view unit, std::string_view after) {
  std::string text{before};
  while (text.size() + unit.size() + after.size() <= size) text += unit;
  text.append(size - text.size() - after.size(), ' ');
  return text.append(after);
}

}  // namespace

MalformedMessages::MalformedMessages(std::uint64_t seed) : random_{seed} {
  const std::filesystem::path folder{test::repository_path("tests/golden/rpc")};
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator{folder}) {
    if (file.path().extension() == ".json") files.push_back(file.path());
  }
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const Json exchanges = Json::parse(std::ifstream{file});
    for (const Json& exchange : exchanges) golden_.push_back(exchange["request"]);
  }
}

std::string MalformedMessages::next(const std::string& marker_id) {
  for (;;) {
    const Json& golden = golden_[random_.below(golden_.size())];
    const std::size_t kind = random_.below(100);
    std::string text = kind < 40   ? damaged_text(golden.dump())
                       : kind < 65 ? with_odd_number(golden)
                       : kind < 80 ? with_odd_field(golden)
                       : kind < 98
                           ? random_bytes()
                           : nested(kind == 98 ? "[" : "{\"a\":", kind == 98 ? "]" : "}", 1 + random_.below(3000));
    std::replace(text.begin(), text.end(), '\n', ' ');
    text = replaced(std::move(text), "\"m1\"", "\"" + marker_id + "\"");
    if (owes_answer(text)) return text;
  }
}

std::string MalformedMessages::damaged_text(std::string text) {
  for (auto times = random_.between(1, 3); times > 0; --times) {
    const std::size_t at = random_.below(text.size() + 1);
    const std::size_t count = std::min(text.size() - at, 1 + random_.below(12));
    switch (random_.below(5)) {
      case 0: text.insert(at, 1, static_cast<char>(random_.below(256))); break;
      case 1: text.erase(at, count); break;
      case 2: text.insert(at, text.substr(at, count)); break;
      case 3: text.resize(at); break;
      default:
        if (at < text.size()) text[at] = static_cast<char>(text[at] ^ (1 << random_.below(8)));
    }
  }
  return text;
}

std::string MalformedMessages::with_odd_number(Json request) {
  return with(std::move(request), true, random_, kOddNumbers.at(random_.below(kOddNumbers.size())));
}

std::string MalformedMessages::with_odd_field(Json request) {
  if (random_.chance(70))
    return with(std::move(request), false, random_, kOddValues.at(random_.below(kOddValues.size())));
  if (!request.is_object() || !request.contains("params") || !request["params"].is_object()) return request.dump();
  Json& params = request["params"];
  if (params.empty() || random_.chance(50)) {
    params["no such field"] = 1;
    return request.dump();
  }
  auto field = params.begin();
  std::advance(field, static_cast<std::ptrdiff_t>(random_.below(params.size())));
  const std::string twice = Json(field.key()).dump() + ":" + field.value().dump();
  if (random_.chance(50)) return replaced(request.dump(), twice, twice + "," + twice);
  params.erase(field.key());
  return request.dump();
}

std::string MalformedMessages::random_bytes() {
  std::string text(1 + random_.below(random_.chance(5) ? 40'000 : 400), ' ');
  const bool plain = random_.chance(30);  // else any bytes
  constexpr std::string_view kJson = "{}[]\",:0123456789.eE+-truefalsn \\u";
  for (char& byte : text) byte = plain ? kJson[random_.below(kJson.size())] : static_cast<char>(random_.below(256));
  return text;
}

std::string extreme_message(std::size_t which, std::size_t limit) {
  constexpr std::string_view kOpen = R"({"jsonrpc":"2.0","id":1,"method":"marker.open","params":{"marker":)";
  switch (which) {
    case 0: return nested("[", "]", 100'000);
    case 1: return nested("[", "", 10'000'000);
    case 2: return nested("[", "]", 10'000'000);
    case 3: return nested("{\"a\":", "}", 5'000'000);
    case 4: return nested("{\"a\":", "", 10'000'000);  // longer than the limit
    case 5: return std::string{kOpen} + nested("[", "]", 10'000'000) + "}}";
    case 6: return long_call(limit, std::string{kOpen} + '"', "x", "\"}}");
    case 7: return long_call(limit, std::string{kOpen} + R"({"shapes":[0)", ",[]", "]}}}");
    case 8: return long_call(limit, std::string{kOpen} + R"({"pieces":[0)", ",{\"at\":[1,2]}", "]}}}");
    case 9: return long_call(limit + 1, std::string{kOpen} + '"', "x", "\"}}");
    default: return std::string(2 * limit, '[');
  }
}

}  // namespace selvage::trials
