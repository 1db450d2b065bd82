#include "xr/xr_error.h"

#include <utility>

#include "base/log.h"

namespace macula::xr {

Error xrError(XrResult result, Text doing) {
    switch (result) {
        case XR_ERROR_SESSION_LOST:
            return {ErrorCode::deviceLost,
                    Text("The headset has ended the session: it was unplugged or fell asleep."), "",
                    Text("Wake it up or plug it in, and begin again; nothing that was chosen is lost.")};
        case XR_ERROR_INSTANCE_LOST:
            return {ErrorCode::deviceLost, Text("The software of the headset has stopped."), "",
                    Text("Start it again, and begin again; nothing that was chosen is lost.")};
        case XR_ERROR_RUNTIME_UNAVAILABLE:
            return {ErrorCode::deviceNotUsable, Text("No software of a headset (OpenXR runtime) answers."),
                    "",
                    Text("Start SteamVR, Monado or what came with the headset, and make it the active OpenXR "
                         "runtime.")};
        case XR_ERROR_FORM_FACTOR_UNAVAILABLE:
            return {ErrorCode::deviceNotUsable, Text("No headset is connected, or it is switched off."), "",
                    Text("Connect the headset, switch it on, and try again.")};
        case XR_ERROR_FORM_FACTOR_UNSUPPORTED:
            return {ErrorCode::deviceNotUsable, Text("The OpenXR runtime knows no headsets."), "",
                    Text("Make the runtime of the headset the active one.")};
        case XR_ERROR_OUT_OF_MEMORY:
            return {ErrorCode::outOfMemory, Text("There is not enough memory for the headset."), "",
                    Text("Close other programs.")};
        default:
            // The log has the number, whose name is in openxr.h.
            log::warning("OpenXR: {} on the way to {}", static_cast<int>(result), doing.english());
            return {ErrorCode::deviceNotUsable, Text("The headset could not {}.", std::move(doing)), "",
                    Text("Restart the software of the headset.")};
    }
}

}  // namespace macula::xr
