// What the process tells its caller, as the `macula` command does.
#pragma once

#include "base/result.h"

namespace macula::viewer {

inline constexpr int kExitDone = 0;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInput = 3;
inline constexpr int kExitDevice = 4;
inline constexpr int kExitCancelled = 130;  // 128 + SIGINT, as shells expect

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
        case ErrorCode::cancelled:
            return kExitCancelled;
    }
    return kExitInput;
}

}  // namespace macula::viewer
