// What holds of every text that a marker may be read from.
#pragma once

#include <functional>
#include <string_view>

#include "protocol/formats/format.h"

namespace selvage::test {

// The reader takes the text or refuses it with words.  A marker that it takes can be judged and written in every form;
// its native form reads back as the same marker.
void demand_sound_reading(std::string_view text, const std::function<Result<MarkerFile>(const Json&)>& read);

}  // namespace selvage::test
