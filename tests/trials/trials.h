// The trials.  Each starts a selvaged of its own, prints its observations and reports faults: counts and answers are
// checked, times and rates are only printed.
#pragma once

#include <cstddef>

#include "tests/trials/faults.h"

namespace selvage::trials {

// `count` drag sessions in total on 32 connections, in both modes, with cancelled and superseded moves; meanwhile two
// other clients read and one compacts.
void drags(std::size_t count, Faults& faults);

// `count` malformed requests, distributed over all listeners.
void malformed(std::size_t count, Faults& faults);

// 64 clients that open, edit, undo, drag, compact, watch, close and reconnect, for `seconds`.
void soak(std::size_t seconds, Faults& faults);

// 500 connections that send a byte now and then and 50 that hardly read, alternating with rounds without them, `rounds`
// times.
void slow(std::size_t rounds, Faults& faults);

// `count` compactions with a deadline of 200 ms while every worker compacts for long, and as many bumps behind one of
// these compactions; then the same again.
void deadlines(std::size_t count, Faults& faults);

// `count` copies of a store with a bit flipped, every tenth cut off instead: a daemon that starts on one has the same
// content or names what is damaged.
void damage(std::size_t count, Faults& faults);

// Clients that try to make a daemon of 512 MiB grow beyond that, first in every known way and then in all ways at once,
// each `rounds` times.  Meanwhile another client reads.
void memory(std::size_t rounds, Faults& faults);

// The start of a daemon with a store of `count` markers of 120 pieces.
void loading(std::size_t count, Faults& faults);

}  // namespace selvage::trials
