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

// How the difference of two pictures is measured.
enum class LossMeasure {
    similar,   // absolute differences, and how alike neighbourhoods are
    absolute,  // absolute differences alone: less work
    squared,   // squares of differences. Where a picture is noisy, what is nearest to it in absolute
               // differences is the median, which is darker than the light that there is; in squares it is
               // the mean
};

// The weight with which squares pull as hard as absolute differences do where these are 0.1, as they usually
// are. Adam remembers for long how hard it was pulled, and would hardly move after a change from one to the
// other.
inline constexpr float kSquaresWeight = 5.0f;

// The loss of a render against a target, both premultiplied, is
//
//   similar:  viewWeight * ((1 - dssimWeight) * L1 + dssimWeight * (1 - SSIM))
//   absolute: viewWeight * L1
//   squared:  viewWeight * kSquaresWeight * L2
//
// with L1 the mean of |x - y| and SSIM the mean index over all pixels and four values of each: the three
// colours over the background, encoded, and the coverage. Nothing is halved. L2 is the mean of the
// squares of J (s_x - s_y), with s the three colours over the background before they are encoded and J the
// derivative of the encoding at the render: what is compared, to first order; of coverage, of x - y. For the
// gradient J counts as a constant: then what is found over many noisy pictures is their mean as light,
// however the display bends it. The mean difference that is reported is then that of J (s_x - s_y).
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
    LossMeasure measure = LossMeasure::similar;
    glm::vec3 background{0.0f};  // 0 to 1; for `display` linear, and not exposed, as in displayColour
    float viewWeight = 1.0f;
    bool coverageOnly = false;  // the target's colours say nothing: as if the render's were right
};

}  // namespace macula::splat
