// The options of the training loss: the same for the device (loss.h) and the reference (reference_loss.h).
#pragma once

#include <glm/glm.hpp>

namespace macula::splat {

// The encoding in which pictures are compared, after they are laid over the background.
enum class LossEncoding {
    none,     // unchanged: for pictures that are display-encoded already
    display,  // as the display shows linear radiance: exposed, tone-mapped, encoded
              // (shaders/lib/picture.glsl)
};

// How the difference of two pictures is measured.
enum class LossMeasure {
    similar,   // absolute differences and SSIM
    absolute,  // absolute differences alone: less work
    squared,   // squared differences. In a noisy picture, absolute differences lead to the median, which is
               // darker than the true light; squares lead to the mean
};

// The weight at which squares give as strong gradients as absolute differences do at 0.1, the usual
// difference. Adam's second moment remembers the strength of gradients for long, so weaker ones would hardly
// move anything after a change of the measure.
inline constexpr float kSquaresWeight = 5.0f;

// The loss of a render against a target, both premultiplied, is
//
//   similar:  viewWeight * ((1 - dssimWeight) * L1 + dssimWeight * (1 - SSIM))
//   absolute: viewWeight * L1
//   squared:  viewWeight * kSquaresWeight * L2
//
// with L1 the mean of |x - y| and SSIM the mean index, both over all pixels and four values of each: the
// three colours over the background, encoded, and the coverage. There is no factor of one half. L2 is the
// mean of the squares of J (s_x - s_y), with s the three colours over the background before they are encoded,
// and J the derivative of the encoding at the render (the encoded difference to first order); for the
// coverage, of x - y. The gradient treats J as a constant: then the optimum over many noisy pictures is their
// mean in linear light, although the display curve is not linear. The reported mean difference is then that
// of J (s_x - s_y).
//
// `none`: colour = rgb + (1 - a) background. `display`: s = exposure * rgb + (1 - a) background, and then
// 0.95 * encodeSrgb(toneMapNeutral(s)) + 0.05 * ln(1 + s): the last term is there because the display curve
// alone has no slope at black and hardly any above white, so pixels that are much too bright would get no
// gradient. All values are clamped to +-10^6; gradients ignore the clamp, so that values beyond it, or below
// black, are drawn back.
//
// SSIM (Wang et al. 2004): Gaussian window of 11 x 11 pixels, standard deviation 1.5, K1 0.01, K2 0.03, range
// 1; windows that reach over the border are renormalised over the pixels they have, and there is a window
// around each pixel.
//
// Pixels of the target that are not finite are unknown: they have no loss, no gradient and no SSIM window,
// and the windows of other pixels leave them out. Where the target is known but the render is not finite,
// there is no gradient, and windows of other pixels treat the render as correct there. Means are always over
// all pixels, so that a view with unknown ones counts less.
struct LossOptions {
    float dssimWeight = 0.2f;  // 0 to 1
    LossEncoding encode = LossEncoding::none;
    float exposure = 1.0f;  // factor; for `display` only
};

// The options that differ from step to step.
struct LossStep {
    LossMeasure measure = LossMeasure::similar;
    glm::vec3 background{0.0f};  // 0 to 1; for `display` linear and without exposure, as in displayColour
    float viewWeight = 1.0f;
    bool coverageOnly = false;  // ignore the target's colours, as if the render's were right
};

}  // namespace macula::splat
