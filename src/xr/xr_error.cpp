#include "xr/xr_error.h"

#include "base/log.h"

namespace macula::xr {

Error xrError(XrResult result, std::string_view doing) {
    switch (result) {
        case XR_ERROR_SESSION_LOST:
            return {ErrorCode::deviceLost,
                    "The headset has ended the session: it was unplugged or fell asleep.", "",
                    "Wake it up or plug it in, and begin again; nothing that was chosen is lost."};
        case XR_ERROR_INSTANCE_LOST:
            return {ErrorCode::deviceLost, "The software of the headset has stopped.", "",
                    "Start it again, and begin again; nothing that was chosen is lost."};
        case XR_ERROR_RUNTIME_UNAVAILABLE:
            return {ErrorCode::deviceNotUsable, "No software of a headset (OpenXR runtime) answers.", "",
                    "Start SteamVR, Monado or what came with the headset, and make it the active OpenXR "
                    "runtime."};
        case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
            return {ErrorCode::deviceNotUsable, "No headset is connected, or it is switched off.", "",
                    "Connect the headset, switch it on, and try again."};
        case XR_ERROR_FORM_FACTOR_UNSUPPORTED:
            return {ErrorCode::deviceNotUsable, "The OpenXR runtime knows no headsets.", "",
                    "Make the runtime of the headset the active one."};
        case XR_ERROR_OUT_OF_MEMORY:
            return {ErrorCode::outOfMemory, "There is not enough memory for the headset.", "",
                    "Close other programs."};
        default:
            // The number is for who reads the log; openxr.h has its name.
            log::warning("OpenXR: {} on the way to {}", static_cast<int>(result), doing);
            return {ErrorCode::deviceNotUsable, fmt::format("The headset could not {}.", doing), "",
                    "Restart the software of the headset."};
    }
}

}  // namespace macula::xr
