// What no lens shows, of each view of a session.
#pragma once

#include <span>
#include <vector>

#include "base/result.h"
#include "xr/eyes.h"
#include "xr/session.h"
#include "xr/visibility_mask.h"

namespace macula::xr {

class EyeMasks {
  public:
    // Asks again where something has changed.
    Result<void> refresh(Session& session);

    // Moves the sides of what each view sees in to what can be seen; `eyes` are all views.
    void narrow(std::span<Eye> eyes);
    // For Swapchains::show, of the views from `firstView` on; empty: all of all can be seen.
    std::vector<std::vector<VisiblePart>> partsOf(const EyePictures& pictures, std::size_t firstView);

  private:
    // What was asked last: fields seldom change.
    struct View {
        VisibilityMask mask;
        Eye asked{.pose = {}, .left = 0.0, .right = 0.0, .up = 0.0, .down = 0.0};
        Eye part;
        Eye shown{.pose = {}, .left = 0.0, .right = 0.0, .up = 0.0, .down = 0.0};
        glm::ivec2 shownPx{0};
        std::vector<VisiblePart> visible;
    };
    std::vector<View> views_;
};

}  // namespace macula::xr
