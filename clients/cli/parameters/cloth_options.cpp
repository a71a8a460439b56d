#include "clients/cli/parameters/cloth_options.h"

#include "clients/cli/parameters/parameter_options.h"

namespace selvage::cli::parameters {
namespace {

const std::vector<ParameterOption>& options_of_cloth() {
  static const auto kOptions = field_options(protocol::schema::describe<protocol::edits::Cloth>());
  return kOptions;
}

}  // namespace

std::vector<command_line::Option> cloth_options() {
  std::vector<command_line::Option> options;
  for (const ParameterOption& one : options_of_cloth()) {
    options.push_back(one.option);
    if (one.option.kind == command_line::Kind::kNumber) options.back().placeholder = "LENGTH";
  }
  return options;
}

Result<protocol::edits::Cloth> cloth_from(const command_line::Values& values) {
  const auto given = params_from(options_of_cloth(), values);
  if (!given) return given.error();
  return protocol::schema::decode<protocol::edits::Cloth>(*given);
}

}  // namespace selvage::cli::parameters
