#include "protocol/files/unused_options.h"

#include <algorithm>
#include <iterator>
#include <string>

namespace selvage::protocol::files {
namespace {

bool is_among(std::string_view name, std::string_view names) {
  const std::string word = " " + std::string{name} + " ";
  return (" " + std::string{names} + " ").find(word) != std::string::npos;
}

}  // namespace

std::vector<Note> unused_options(const trade::ReadingOptions& options, std::string_view used, std::string_view what) {
  const trade::ReadingOptions standard;
  const bool order = options.order && !options.one_of_each_size;  // a plan reads its order itself
  const std::pair<std::string_view, bool> given[] = {{"unit", options.unit.has_value()},
                                                     {"width", options.width.has_value()},
                                                     {"sizes", !options.sizes.empty()},
                                                     {"fold", options.fold != standard.fold},
                                                     {"nap", options.nap != standard.nap},
                                                     {"tolerance", options.tolerance != standard.tolerance},
                                                     {"rules", options.rules.has_value()},
                                                     {"order", order},
                                                     {"plain", options.plain}};
  std::vector<Note> notes;
  for (const auto& [name, is_given] : given) {
    const bool decided = order && is_among("order", used) && is_among(name, "sizes nap");
    if (!is_given || (is_among(name, used) && !decided)) continue;
    notes.push_back({"", "the option " + std::string{name} + " has no effect" +
                             (decided ? ": the order decides" : " on " + std::string{what})});
  }
  return notes;
}

}  // namespace selvage::protocol::files
