// Properties of reading any text as a marker.
#pragma once

#include <functional>
#include <string_view>

#include "protocol/formats/format.h"

namespace selvage::test {

// The reader either accepts the text or rejects it with an error message.  A marker that was accepted can be checked
// for validity and written in every format, and its native document reads back as the same marker.
void demand_sound_reading(std::string_view text, const std::function<Result<MarkerFile>(const Json&)>& read);

}  // namespace selvage::test
