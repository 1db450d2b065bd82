#include "xr/interaction_profiles.h"

#include "xr/openxr.h"

namespace macula::xr {

namespace {

constexpr InteractionProfile kProfiles[] = {
    {.name = "/interaction_profiles/khr/simple_controller",
     .extension = nullptr,
     .grab = "select/click",
     .cut = "menu/click",
     .press = "select/click",
     .turn = nullptr,
     .turnsWhile = nullptr},
    {.name = "/interaction_profiles/oculus/touch_controller",
     .extension = nullptr,
     .grab = "squeeze/value",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x",
     .turnsWhile = nullptr},
    {.name = "/interaction_profiles/valve/index_controller",
     .extension = nullptr,
     .grab = "squeeze/value",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x",
     .turnsWhile = nullptr},
    {.name = "/interaction_profiles/htc/vive_controller",
     .extension = nullptr,
     .grab = "squeeze/click",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "trackpad/x",
     .turnsWhile = "trackpad/click"},
    {.name = "/interaction_profiles/microsoft/motion_controller",
     .extension = nullptr,
     .grab = "squeeze/click",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x",
     .turnsWhile = nullptr},
    {.name = "/interaction_profiles/hp/mixed_reality_controller",
     .extension = XR_EXT_HP_MIXED_REALITY_CONTROLLER_EXTENSION_NAME,
     .grab = "squeeze/value",
     .cut = "trigger/value",
     .press = "trigger/value",
     .turn = "thumbstick/x",
     .turnsWhile = nullptr},
};

}  // namespace

std::span<const InteractionProfile> interactionProfiles() {
    return kProfiles;
}

}  // namespace macula::xr
