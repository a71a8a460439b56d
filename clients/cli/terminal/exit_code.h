// What `selvage` exits with.  These numbers never change their meaning.
#pragma once

#include "core/base/error.h"

namespace selvage::cli::terminal {

enum class ExitCode : int {
  kOk = 0,
  kNotValid = 1,    // the marker is not valid
  kBadUsage = 2,    // the command line makes no sense
  kBadInput = 3,    // the marker cannot be read: not JSON, a field wrong, a shape that is none; or a parameter
  kFile = 4,        // a file cannot be read or written
  kRefused = 5,     // the motion cannot start: pieces overlap too deeply
  kServer = 6,      // the daemon cannot be reached, or would not do it now
  kCancelled = 130  // interrupted; the best marker so far was written
};

inline constexpr char kExitCodesHelp[] =
    "Exit codes:\n"
    "  0    done\n"
    "  1    the marker is not valid\n"
    "  2    bad usage\n"
    "  3    bad input: not a marker, or one with a mistake in it; parameters with a mistake\n"
    "  4    a file cannot be read or written\n"
    "  5    refused: pieces overlap or leave the strip too far to be healed\n"
    "  6    the daemon cannot be reached, is busy or at a limit\n"
    "  130  interrupted (Ctrl-C): the best marker so far was written; from a daemon, nothing";

// Of an error met while reading and writing.
[[nodiscard]] ExitCode exit_code_of(const Error& error);

// Prints the error to stderr, after the command's name.
void report(const Error& error);

}  // namespace selvage::cli::terminal
