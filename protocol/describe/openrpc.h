// The machine-readable description of all methods: an OpenRPC 1.2.6 document (https://spec.open-rpc.org), made from the
// descriptors of their parameters and results.
//
// A method's result is an object; the properties of its schema are the fields of the result.  The notifications that
// the daemon sends are listed under "x-notifications", with a name, a summary and params, like methods.
#pragma once

#include <string_view>

#include "protocol/json/json_text.h"
#include "protocol/schema/description.h"

namespace selvage::protocol::describe {

// JSON Schema (draft 7) of a type.
[[nodiscard]] Json type_schema(const schema::Type& type);

// Describes all methods of the table.
[[nodiscard]] Json openrpc_document(std::string_view version);

}  // namespace selvage::protocol::describe
