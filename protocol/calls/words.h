// The words of a method, told: what each parameter and each field of the result is, beside the decoder that reads it.
//
// A type is a name: "string", "integer", "number", "boolean", "object", "null", a word in quotes ('add'), or one of the
// types of protocol/schemas.h; followed by [] for a list, by [2] for a list of exactly two; several parted by |.
// openrpc.h makes the machine-readable description of all methods from these.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace selvage::protocol::calls {

struct Word {
  std::string_view name, type;
  bool required{};  // in a result: always there
  std::string_view meaning;
};

inline constexpr bool kRequired = true, kOptional = false;

struct MethodWords {
  std::string_view summary;  // empty: nobody has told them
  std::span<const Word> params, results;
};

// Several tables as one, in order.
template <std::size_t... sizes>
constexpr std::array<Word, (sizes + ... + 0)> together(const std::array<Word, sizes>&... parts) {
  std::array<Word, (sizes + ... + 0)> all{};
  auto end = all.begin();
  ((end = std::copy(parts.begin(), parts.end(), end)), ...);
  return all;
}

// What methods in rounds take and answer.
inline constexpr std::array kRoundsParams{Word{"rounds", "integer", kOptional, "At most this many, 0 to 100,000."}};
inline constexpr std::array kEffortParams = together(
    std::array{Word{"accuracy", "Accuracy", kOptional, "How hard to try; standard when absent."}}, kRoundsParams,
    std::array{Word{"simplification", "number", kOptional,
                    "Outlines that are farther apart than this part of the strip's width are modelled by "
                    "simpler ones that hold them, 0 to 1; 0 when absent."}});
inline constexpr std::array kStopResults{Word{"stop", "StopReason", kRequired, "Why it ended."}};
inline constexpr std::array kRoundsResults =
    together(std::array{Word{"rounds", "integer", kRequired, "Rounds that were done."}}, kStopResults);

}  // namespace selvage::protocol::calls
