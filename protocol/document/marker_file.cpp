#include "protocol/document/marker_file.h"

namespace selvage::protocol::document {

std::string_view name_of(Format format) {
  return kFormatNames[static_cast<std::size_t>(format)];
}

}  // namespace selvage::protocol::document
