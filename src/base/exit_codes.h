// The exit codes of the programs.
#pragma once

#include "base/result.h"

namespace macula {

inline constexpr int kExitDone = 0;
inline constexpr int kExitFault = 1;        // a fault of the program: please report it
inline constexpr int kExitUsage = 2;        // wrong usage, or an output that cannot be written
inline constexpr int kExitInput = 3;        // the input is not usable
inline constexpr int kExitDevice = 4;       // the device is not usable, or memory ran out
inline constexpr int kExitArchive = 5;      // a PACS is not usable
inline constexpr int kExitCancelled = 130;  // 128 + SIGINT, as shells expect

// For help texts.
inline constexpr const char* kExitCodes =
    "0 done, 1 a fault of the program, 2 usage or output not writable, 3 input not usable, 4 device not "
    "usable or out of memory, 5 archive not usable, 130 stopped";

constexpr int exitCodeOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::usage:
        case ErrorCode::outputNotWritable:
            return kExitUsage;
        case ErrorCode::inputNotUsable:
            return kExitInput;
        case ErrorCode::deviceNotUsable:
        case ErrorCode::deviceLost:
        case ErrorCode::outOfMemory:
            return kExitDevice;
        case ErrorCode::archiveNotUsable:
            return kExitArchive;
        case ErrorCode::cancelled:
            return kExitCancelled;
    }
    return kExitInput;
}

}  // namespace macula
