// What a step of training is told about its loss: the same for the device (loss.h) and the reference
// (reference_loss.h).
#pragma once

#include <glm/glm.hpp>

namespace macula::splat {

// What the pictures are compared as, once they lie over the background.
enum class LossEncoding {
    none,     // as they are: pictures that are display-encoded already
    display,  // as the display shows linear radiance: exposed, tone-mapped, encoded
              // (shaders/lib/picture.glsl)
};

// The loss of a render against a target, both premultiplied, is
//
//   viewWeight * ((1 - dssimWeight) * L1 + dssimWeight * (1 - SSIM))
//
// with L1 the mean of |x - y| and SSIM the mean index over all pixels and four values of each: the three
// colours over the background, encoded, and the coverage. Nothing is halved.
//
// `none`: colour = rgb + (1 - a) background. `display`: s = exposure * rgb + (1 - a) background, and then
// 0.95 * encodeSrgb(toneMapNeutral(s)) + 0.05 * ln(1 + s): the last part is there because the display alone
// has no slope at black and hardly any above white, so what is much too bright would never be told so. All is
// clamped to +-10^6; gradients pass the clamp as if it were not there, so what is beyond it, or below black,
// is drawn back.
//
// SSIM (Wang et al. 2004): Gaussian window of 11 x 11 pixels, standard deviation 1.5, K1 0.01, K2 0.03, range
// 1; windows that reach over the border are renormalised over the pixels they have, and there is a window
// around each pixel.
//
// Pixels of the target that are not finite are unknown: no loss, no gradient, no SSIM window around them, and
// left out of others. Where the target is known but the render is not finite there is no gradient, and for
// others it is as if it were right there. Means are always over all pixels, so that a view with unknown ones
// counts less.
struct LossOptions {
    float dssimWeight = 0.2f;  // 0 to 1
    LossEncoding encode = LossEncoding::none;
    float exposure = 1.0f;  // factor; for `display` only
};

// What differs from step to step.
struct LossStep {
    glm::vec3 background{0.0f};  // 0 to 1; for `display` linear, and not exposed, as in displayColour
    float viewWeight = 1.0f;
    bool coverageOnly = false;  // the target's colours say nothing: as if the render's were right
};

}  // namespace macula::splat
