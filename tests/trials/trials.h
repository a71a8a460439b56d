// The trials.  Each starts a selvaged of its own, prints what it saw, and hands back what must not have been: counts
// and answers are judged, times and rates are only told.
#pragma once

#include <cstddef>

#include "tests/trials/faults.h"

namespace selvage::trials {

// Dragging hands on 32 connections, `count` drags in all, in both modes, with cancelled and superseded moves; two
// others read, and one compacts, all the while.
void drags(std::size_t count, Faults& faults);

// `count` malformed requests, spread over every door.
void malformed(std::size_t count, Faults& faults);

// 64 clients that open, edit, undo, drag, compact, watch, close and come again, for `seconds`.
void soak(std::size_t seconds, Faults& faults);

// 500 connections that send a byte now and then and 50 that hardly read, in turns with none of them, `rounds` times.
void slow(std::size_t rounds, Faults& faults);

}  // namespace selvage::trials
