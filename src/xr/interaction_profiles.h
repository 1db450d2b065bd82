// Which control of which kind of controller does what.
#pragma once

#include <span>

namespace macula::xr {

// Paths below /user/hand/left/input and right; null: it has none.
struct InteractionProfile {
    const char* name;
    const char* extension;  // that it needs; null: none
    const char* grab;
    const char* cut;
    const char* press;
    const char* turn;        // a stick, -1 to 1
    const char* turnsWhile;  // a pad that is touched all the time turns only while this is pressed
};

std::span<const InteractionProfile> interactionProfiles();

}  // namespace macula::xr
