// The loss (loss_options.h) as scalar C++ in double, slow, for tests: SSIM by its textbook formula, window by
// window.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/splat/train/loss_options.h"

namespace macula::splat {

struct ReferenceLoss {
    double loss = 0.0;                 // weighted; `gradient` is its derivative
    double l1 = 0.0;                   // mean over pixels and channels
    double dssim = 0.0;                // mean of 1 - SSIM over the same; 0 if the loss has no SSIM
    std::uint64_t unknownPixels = 0;   // pixels of the target that are not finite
    std::uint64_t badRendered = 0;     // pixels of the render that are not finite
    std::vector<glm::dvec4> gradient;  // with respect to the render's premultiplied RGBA
};

// The pictures are premultiplied and of one size, row 0 on top.
ReferenceLoss referenceLoss(int width, int height, std::span<const glm::dvec4> render,
                            std::span<const glm::dvec4> target, const LossOptions& options,
                            const LossStep& step);

// The values of a pixel that are compared: three colours and coverage.
glm::dvec4 referenceCompared(const glm::dvec4& premultiplied, const LossOptions& options,
                             const glm::dvec3& background);

// Does what recordDownsample does.
std::vector<glm::dvec4> referenceDownsample(std::span<const glm::dvec4> pixels, const glm::ivec2& fromSize,
                                            const glm::ivec2& toSize);

}  // namespace macula::splat
