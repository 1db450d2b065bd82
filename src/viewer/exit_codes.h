// What the process tells its caller, as the `macula` command does.
#pragma once

#include "base/result.h"

namespace macula::viewer {

inline constexpr int kExitDone = 0;
inline constexpr int kExitFailed = 1;
inline constexpr int kExitUsage = 2;
inline constexpr int kExitInput = 3;
inline constexpr int kExitDevice = 4;

constexpr int exitCodeOf(ErrorCode code) {
    switch (code) {
        case ErrorCode::usage:
            return kExitUsage;
        case ErrorCode::inputNotUsable:
            return kExitInput;
        case ErrorCode::deviceNotUsable:
        case ErrorCode::outOfMemory:
            return kExitDevice;
        case ErrorCode::outputNotWritable:
        case ErrorCode::cancelled:
            return kExitFailed;
    }
    return kExitFailed;
}

}  // namespace macula::viewer
