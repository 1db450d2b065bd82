// The table of controllers, and what each of their controls does.
#pragma once

#include <span>

namespace macula::xr {

// Paths below /user/hand/left/input and right; null: the controller has no such control.
struct InteractionProfile {
    const char* name;
    const char* extension;  // the extension that it needs; null: none
    const char* grab;
    const char* cut;
    const char* press;
    const char* turn;        // a stick, -1 to 1
    const char* turnsWhile;  // for a pad, which a thumb always touches: turns only while this is pressed
};

std::span<const InteractionProfile> interactionProfiles();

}  // namespace macula::xr
