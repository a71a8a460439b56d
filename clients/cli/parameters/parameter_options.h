// Options of the command line for the parameters of a method, and for the fields of any other message.  They are made
// from the same descriptor as the protocol.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "clients/cli/command_line/option.h"
#include "clients/cli/command_line/values.h"
#include "core/base/result.h"
#include "protocol/calls/method.h"

namespace selvage::cli::parameters {

// An option that sets a parameter.
struct ParameterOption {
  protocol::schema::FieldDescription parameter;
  command_line::Option option;
  double divisor{1};  // for a number: the parameter is the option's value divided by this
};

// One option for each parameter, except for those of the call itself, such as revisions and deadlines.  "popOut"
// becomes --pop-out; parameters that are lists or objects are given as JSON.
[[nodiscard]] std::vector<ParameterOption> parameter_options(const protocol::calls::Method& method);

// One option for each field of a message that is not the parameters of a method.
[[nodiscard]] std::vector<ParameterOption> field_options(const std::vector<protocol::schema::FieldDescription>& fields);

// "popOut" becomes "--pop-out".
[[nodiscard]] std::string option_name(std::string_view parameter);
// The text without the full stop at its end, as help texts have none.
[[nodiscard]] std::string without_full_stop(std::string_view text);

// The parameters of a call.  Errors: kSyntax and others of protocol::json::parse, for an option that is given as JSON.
[[nodiscard]] Result<Json> params_from(const std::vector<ParameterOption>& options, const command_line::Values& values);

}  // namespace selvage::cli::parameters
