// Properties of reading any text as a file of the trade.
#pragma once

#include <string_view>

#include "protocol/files/reading.h"

namespace selvage::test {

// The reader either accepts the text or rejects it with an error message.  A marker that was accepted is a Marker; its
// native form reads back as the same marker, which is tried of one text in eight, and small ones can be written in
// every format, which is tried of one text in 512.
void demand_sound_file(std::string_view text, const protocol::trade::ReadingOptions& options = {});

}  // namespace selvage::test
