// How far what is shown can be trusted to be what is there.
#pragma once

#include <string>
#include <vector>

#include "live/frame/render_events.h"

namespace macula::app {

struct Fidelity {
    bool isFinal = false;  // nothing will change any more, unless something else is wanted
    // What is between this frame and a picture that was traced from here, with all its pixels and samples and
    // without a filter; words for a person. Nothing for such a picture.
    std::vector<std::string> because = {};
};

Fidelity fidelityOf(const FrameShown& frame);

}  // namespace macula::app
