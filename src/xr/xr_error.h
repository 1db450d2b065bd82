// Translates an XrResult into an error for a person.
#pragma once

#include "base/result.h"
#include "xr/openxr.h"

namespace macula::xr {

// `doing` completes "The headset could not ...". A lost session or instance becomes deviceLost: the caller
// may begin another one.
Error xrError(XrResult result, Text doing);

}  // namespace macula::xr

// Returns the Error from the enclosing function when an OpenXR call fails.
#define MACULA_XR_TRY(call, doing)                                                          \
    do {                                                                                    \
        const XrResult maculaXrResult = (call);                                             \
        if (XR_FAILED(maculaXrResult)) return ::macula::xr::xrError(maculaXrResult, doing); \
    } while (false)
