// Which controls each kind of controller has: OpenXR 1.0, "Interaction Profile Paths", and the extensions'
// own.
#include <algorithm>
#include <array>

#include "xr/runtime/state.h"

namespace macula::xr_script {

namespace {

struct Profile {
    const char* name;
    std::vector<std::string> controls;  // of either hand, behind "/user/hand/left"
};

const std::vector<Profile>& profiles() {
    static const std::vector<std::string> usual{"/input/grip/pose", "/input/aim/pose", "/output/haptic"};
    const auto with = [](std::vector<std::string> controls) {
        controls.insert(controls.end(), usual.begin(), usual.end());
        return controls;
    };
    static const std::vector<Profile> all{
        {"/interaction_profiles/khr/simple_controller", with({"/input/select/click", "/input/menu/click"})},
        {"/interaction_profiles/oculus/touch_controller",
         with({"/input/squeeze/value", "/input/trigger/value", "/input/trigger/touch", "/input/thumbstick",
               "/input/thumbstick/x", "/input/thumbstick/y", "/input/thumbstick/click"})},
        {"/interaction_profiles/htc/vive_controller",
         with({"/input/squeeze/click", "/input/menu/click", "/input/trigger/click", "/input/trigger/value",
               "/input/trackpad", "/input/trackpad/x", "/input/trackpad/y", "/input/trackpad/click",
               "/input/trackpad/touch"})},
        {"/interaction_profiles/valve/index_controller",
         with({"/input/squeeze/value", "/input/squeeze/force", "/input/trigger/click", "/input/trigger/value",
               "/input/thumbstick", "/input/thumbstick/x", "/input/thumbstick/y", "/input/thumbstick/click",
               "/input/trackpad/x", "/input/trackpad/force"})},
        {"/interaction_profiles/microsoft/motion_controller",
         with({"/input/menu/click", "/input/squeeze/click", "/input/trigger/value", "/input/thumbstick",
               "/input/thumbstick/x", "/input/thumbstick/y", "/input/thumbstick/click", "/input/trackpad/x",
               "/input/trackpad/click"})},
        {"/interaction_profiles/hp/mixed_reality_controller",
         with({"/input/menu/click", "/input/squeeze/value", "/input/trigger/value", "/input/thumbstick",
               "/input/thumbstick/x", "/input/thumbstick/y", "/input/thumbstick/click"})}};
    return all;
}

bool isEnabled(const char* extension) {
    return state().extensions.contains(extension);
}

}  // namespace

bool hasControl(const std::string& profile, const std::string& path) {
    if (profile == "/interaction_profiles/ext/eye_gaze_interaction")
        return isEnabled(XR_EXT_EYE_GAZE_INTERACTION_EXTENSION_NAME) &&
               path == "/user/eyes_ext/input/gaze_ext/pose";
    if (profile == "/interaction_profiles/hp/mixed_reality_controller" &&
        !isEnabled(XR_EXT_HP_MIXED_REALITY_CONTROLLER_EXTENSION_NAME))
        return false;
    for (const Profile& known : profiles()) {
        if (known.name != profile) continue;
        for (const std::string hand : {"/user/hand/left", "/user/hand/right"})
            for (const std::string& control : known.controls)
                if (path == hand + control) return true;
    }
    return false;
}

}  // namespace macula::xr_script
