#include "pipeline/splat/train/picture_pyramid.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "base/is_finite.h"

namespace macula::splat {

namespace {

constexpr int kLeastSide = 16;  // in pixels: smaller pictures have no room for an SSIM window

bool isUsable(const TrainingView& given) {
    const glm::ivec2 size = given.view.sizePx;
    return given.pixels.size() == static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) &&
           std::any_of(given.pixels.begin(), given.pixels.end(),
                       [](const glm::vec4& pixel) { return isFinite(pixel); }) &&
           given.weight > 0.0f && given.weight <= kMaxViewWeight;
}

RasterView scaled(RasterView view, const glm::ivec2& sizePx) {
    const glm::dvec2 scale = glm::dvec2(sizePx) / glm::dvec2(view.sizePx);
    view.focalPx *= scale;
    view.principalPx *= scale;
    view.sizePx = sizePx;
    return view;
}

}  // namespace

Result<PicturePyramid> PicturePyramid::upload(const std::shared_ptr<gpu::Device>& device,
                                              const LossKernels& kernels, const TrainingView& given) {
    MACULA_TRY_VOID(validate(given.view));
    if (!isUsable(given)) {
        return Error{ErrorCode::inputNotUsable,
                     Text("A picture to learn from is empty or not of its view's size."),
                     {},
                     Text("Make it again.")};
    }
    const glm::ivec2 size = given.view.sizePx;
    MACULA_TRY(DevicePicture picture,
               DevicePicture::upload(device, "picture to learn from", size.x, size.y, given.pixels));
    MACULA_TRY(LossTarget target, LossTarget::create(kernels, std::move(picture)));
    return PicturePyramid(device, {given.view, std::move(target)});
}

Result<const PictureLevel*> PicturePyramid::halved(int times, const LossKernels& kernels) {
    MACULA_CHECK(times >= 0);
    while (static_cast<int>(levels_.size()) <= times) {
        const PictureLevel& larger = levels_.back();
        const glm::ivec2 size = (larger.view.sizePx + 1) / 2;
        if (std::min(size.x, size.y) < kLeastSide) break;
        MACULA_TRY(DevicePicture picture, DevicePicture::create(device_, "smaller picture", size.x, size.y));
        MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "make smaller"));
        recordDownsample(recorder, kernels, larger.target.picture(), picture);
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        MACULA_TRY(LossTarget target, LossTarget::create(kernels, std::move(picture)));
        const RasterView smaller = scaled(whole().view, size);
        levels_.push_back({smaller, std::move(target)});
    }
    const auto last = static_cast<int>(levels_.size()) - 1;
    return &levels_[static_cast<std::size_t>(std::min(times, last))];
}

}  // namespace macula::splat
