// The lines of a text in a DXF file: a TEXT has one, an MTEXT one for each paragraph, without its formatting codes.
// Source: Autodesk's DXF reference, "MTEXT", and its list of format codes for paragraph text.
#pragma once

#include <string>
#include <vector>

#include "protocol/trade/dxf/drawing.h"
#include "protocol/trade/text.h"

namespace selvage::protocol::trade::dxf {

// As UTF-8, without blanks at the ends; empty lines are left out.
[[nodiscard]] std::vector<std::string> text_lines(const Entity& entity, Encoding encoding);

}  // namespace selvage::protocol::trade::dxf
