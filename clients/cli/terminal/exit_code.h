// The exit codes of `selvage`.  These numbers never change their meaning.
#pragma once

namespace selvage::cli::terminal {

enum class ExitCode : int {
  kOk = 0,
  kNotValid = 1,    // the marker is not valid
  kBadUsage = 2,    // the command line is incorrect
  kBadInput = 3,    // the marker or a parameter is invalid: not JSON, a wrong field, an outline that is not simple
  kFile = 4,        // a file cannot be read or written
  kRefused = 5,     // the motion cannot start: pieces overlap too deeply
  kServer = 6,      // the daemon cannot be reached, is busy or has reached a limit
  kCancelled = 130  // interrupted; the best marker so far was written
};

inline constexpr char kExitCodesHelp[] =
    "Exit codes:\n"
    "  0    success\n"
    "  1    the marker is not valid\n"
    "  2    incorrect usage\n"
    "  3    invalid input: not a marker, or an error in the marker or in the parameters\n"
    "  4    a file cannot be read or written\n"
    "  5    refused: pieces overlap too deeply, or extend too far outside the strip, to be repaired\n"
    "  6    the daemon cannot be reached, is busy or has reached a limit\n"
    "  130  interrupted (Ctrl-C): the best marker so far was written; with a daemon, nothing was written";

}  // namespace selvage::cli::terminal
