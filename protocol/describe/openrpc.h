// The machine-readable description of all methods: an OpenRPC 1.2.6 document (https://spec.open-rpc.org), made of the
// descriptors of their parameters and results.
//
// A method's result is an object, whose schema's properties are the fields of the result.  What the daemon sends
// without being asked is under "x-notifications": name, summary and params, as of a method.
#pragma once

#include <string_view>

#include "protocol/json/json_text.h"
#include "protocol/schema/description.h"

namespace selvage::protocol::describe {

// JSON Schema (draft 7) of a type.
[[nodiscard]] Json type_schema(const schema::Type& type);

// Of all methods of the table.
[[nodiscard]] Json openrpc_document(std::string_view version);

}  // namespace selvage::protocol::describe
