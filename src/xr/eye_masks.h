// The parts of each view of a session that no lens shows.
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
    // Asks the headset again if its masks have changed.
    Result<void> refresh(Session& session);

    // Narrows the field of each view to what its lens shows; `eyes` are all views.
    void narrow(std::span<Eye> eyes);
    // The visible parts of the pictures of the views from `firstView` on, for Swapchains::show; empty:
    // everything is visible.
    std::vector<std::vector<VisiblePart>> partsOf(const EyePictures& pictures, std::size_t firstView);

  private:
    // Caches the last results, because fields seldom change.
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
