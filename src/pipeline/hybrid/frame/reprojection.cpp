#include "pipeline/hybrid/frame/reprojection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/hybrid/frame/texel_room.h"
#include "shaders/hybrid.h"

namespace macula::hybrid {

namespace {

struct PictureAxes {
    glm::vec3 right, up, forward;
};

// `right` and `up` are half of the picture's width and height at distance 1.
Result<PictureAxes> axesOf(const Camera& camera, const glm::ivec2& sizePx) {
    MACULA_TRY(const CameraBasis axes, basis(camera));
    const double halfHeight = std::tan(0.5 * glm::radians(camera.verticalFovDeg));
    const double halfWidth = halfHeight * double(sizePx.x) / double(sizePx.y);
    return PictureAxes{axes.right * halfWidth, axes.up * halfHeight, axes.forward};
}

double pixelAngle(const Camera& camera, const glm::ivec2& sizePx) {
    return 2.0 * std::tan(0.5 * glm::radians(camera.verticalFovDeg)) / double(sizePx.y);
}

gpu::Threads threadsOf(const glm::ivec2& sizePx) {
    return {static_cast<std::uint32_t>(sizePx.x), static_cast<std::uint32_t>(sizePx.y)};
}

}  // namespace

Result<shared::ReprojectPush> reprojectionOf(const Camera& before, const glm::ivec2& beforeSizePx,
                                             const Camera& now, const glm::ivec2& sizePx, const Box& seenMm,
                                             double edgeFade) {
    MACULA_TRY(const PictureAxes here, axesOf(now, sizePx));
    MACULA_TRY(const PictureAxes there, axesOf(before, beforeSizePx));
    return shared::ReprojectPush{.right = here.right,
                                 .up = here.up,
                                 .forward = here.forward,
                                 .oursMm = now.positionMm - before.positionMm,
                                 .beforeRight = there.right,
                                 .beforeUp = there.up,
                                 .beforeForward = there.forward,
                                 .middleMm = seenMm.centre() - now.positionMm,
                                 .radiusMm = float(0.5 * seenMm.diagonal()),
                                 .size = sizePx,
                                 .beforeSize = beforeSizePx,
                                 .firstPx = glm::ivec2(0),
                                 .edgeFade = float(edgeFade)};
}

// The earlier picture, and the nearest and farthest depth of the scene, bound a frustum. Its image lies
// within the box around the images of its corners.
PixelRegion reprojectedRegion(const Camera& before, const glm::ivec2& beforeSizePx, const Camera& now,
                              const glm::ivec2& sizePx, const Box& seenMm) {
    const PictureAxes here = *axesOf(now, sizePx);
    const PictureAxes there = *axesOf(before, beforeSizePx);
    const glm::dvec2 whole(sizePx);
    double nearMm = std::numeric_limits<double>::infinity();  // along the axis of the earlier picture
    double farMm = 0.0;
    for (const glm::dvec3& p : cornersOf(seenMm)) {
        const double depthMm = glm::dot(p - before.positionMm, glm::dvec3(there.forward));
        nearMm = std::min(nearMm, depthMm);
        farMm = std::max(farMm, depthMm);
    }
    nearMm = std::max(nearMm, 1e-3 * seenMm.diagonal());
    farMm = std::max(farMm, nearMm);
    glm::dvec2 low = whole;
    glm::dvec2 high(0.0);
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 ray = glm::dvec3(there.forward) +
                               glm::dvec3(there.right) * ((corner & 1) != 0 ? 1.0 : -1.0) +
                               glm::dvec3(there.up) * ((corner & 2) != 0 ? 1.0 : -1.0);
        const glm::dvec3 p = before.positionMm + ray * ((corner & 4) != 0 ? farMm : nearMm) - now.positionMm;
        const double along = glm::dot(p, glm::dvec3(here.forward));
        if (!(along > 1e-3 * glm::length(p))) return {glm::ivec2(0), sizePx};  // beside the eye, or behind it
        const glm::dvec3 right(here.right);
        const glm::dvec3 up(here.up);
        const glm::dvec2 place(0.5 + 0.5 * glm::dot(p, right) / (along * glm::dot(right, right)),
                               0.5 - 0.5 * glm::dot(p, up) / (along * glm::dot(up, up)));
        low = glm::min(low, place * whole);
        high = glm::max(high, place * whole);
    }
    const glm::ivec2 first = glm::ivec2(glm::clamp(low, glm::dvec2(0.0), whole)) / 8 * 8;
    const glm::ivec2 last = glm::ivec2(glm::ceil(glm::clamp(high, glm::dvec2(0.0), whole)));
    return {first, glm::max(last - first, glm::ivec2(0))};
}

Result<Reprojection> Reprojection::create(const std::shared_ptr<gpu::Device>& device) {
    MACULA_TRY(gpu::Kernel capture, gpu::Kernel::create(device, shaders::hybrid_capture_comp));
    MACULA_TRY(gpu::Kernel reproject, gpu::Kernel::create(device, shaders::hybrid_reproject_comp,
                                                          {.specializations = {{"kHasSplats", false}}}));
    MACULA_TRY(gpu::Kernel bySplats, gpu::Kernel::create(device, shaders::hybrid_reproject_comp,
                                                         {.specializations = {{"kHasSplats", true}}}));
    MACULA_TRY(gpu::Kernel feather, gpu::Kernel::create(device, shaders::hybrid_feather_comp));
    return Reprojection(device,
                        {std::move(capture), std::move(reproject), std::move(bySplats), std::move(feather)});
}

Result<CapturedPicture> Reprojection::capture(trace::PathTracer& tracer, const trace::View& view,
                                              const Box& seenMm, const glm::ivec2& keptPx) {
    MACULA_CHECK(!view.foveation.has_value());
    const glm::ivec2 tracedPx(view.width, view.height);
    const glm::ivec2 sizePx = keptPx.x > 0 && keptPx.y > 0 ? keptPx : tracedPx;
    const glm::ivec2 besidePx = tracedPx - sizePx;
    MACULA_CHECK(besidePx.x >= 0 && besidePx.y >= 0 && besidePx.x % 2 == 0 && besidePx.y % 2 == 0);
    MACULA_TRY(splat::DevicePicture lights,
               splat::DevicePicture::create(device_, "captured light", sizePx.x, sizePx.y));
    const std::uint64_t pixels = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y);
    MACULA_TRY(gpu::TexelBuffer depths,
               makeTexels(device_, "captured depths", VK_FORMAT_R32G32_SFLOAT, pixels));
    MACULA_TRY(gpu::TexelBuffer trusts, makeTexels(device_, "trust", VK_FORMAT_R32_SFLOAT, pixels));
    MACULA_TRY(gpu::Buffer variances, gpu::Buffer::create(device_, {.label = "captured variances",
                                                                    .bytes = pixels * sizeof(float)}));
    MACULA_TRY(const trace::Guides* guides, tracer.guides());
    MACULA_TRY(const trace::TracedLight light, tracer.noisyLight());
    const shared::CapturePush push{.size = sizePx,
                                   .firstPx = besidePx / 2,
                                   .tracedSize = tracedPx,
                                   .pixelAngle = float(pixelAngle(view.camera, tracedPx)),
                                   .thinMm = float(0.25 * seenMm.diagonal()),
                                   .areMeans = light.areMeans ? 1 : 0};
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "capture"));
    recorder.dispatch(kernels_.capture, threadsOf(sizePx), push,
                      {*light.values, *light.counts, guides->surfaces(), guides->motions(), *light.variances,
                       lights.texels.buffer(), depths.buffer(), variances, trusts.buffer()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    Camera camera = view.camera;
    if (sizePx.y != tracedPx.y)
        camera.verticalFovDeg =
            2.0 * glm::degrees(std::atan(std::tan(0.5 * glm::radians(camera.verticalFovDeg)) *
                                         double(sizePx.y) / double(tracedPx.y)));
    return CapturedPicture{
        camera, sizePx, std::move(lights), std::move(depths), std::move(variances), std::move(trusts)};
}

Result<ReprojectedPicture> Reprojection::reproject(const CapturedPicture& before, const Camera& now,
                                                   const glm::ivec2& sizePx, const Box& seenMm,
                                                   double edgeFade,
                                                   const std::optional<DrawnSplats>& splats) {
    MACULA_TRY(shared::ReprojectPush push,
               reprojectionOf(before.camera, before.sizePx, now, sizePx, seenMm, edgeFade));
    const std::uint64_t pixels = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y);
    MACULA_TRY_VOID(makeRoom(lights_, device_, "reprojected light", VK_FORMAT_R32G32B32A32_SFLOAT, pixels));
    MACULA_TRY_VOID(makeRoom(hardWeights_, device_, "hard weights of reprojected light",
                             VK_FORMAT_R32G32_SFLOAT, pixels));
    MACULA_TRY_VOID(
        makeRoom(weights_, device_, "weights of reprojected light", VK_FORMAT_R32_SFLOAT, pixels));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "reproject"));
    recorder.fill(hardWeights_->buffer(), 0);
    recorder.fill(weights_->buffer(), 0);
    const PixelRegion region = reprojectedRegion(before.camera, before.sizePx, now, sizePx, seenMm);
    push.firstPx = region.firstPx;
    if (region.sizePx.x > 0 && region.sizePx.y > 0) {
        recorder.dispatch(
            splats ? kernels_.reprojectBySplats : kernels_.reproject, threadsOf(region.sizePx), push,
            {before.lights.texels, before.depths, before.trusts,
             splats ? splats->picture->texels : before.lights.texels,
             splats ? *splats->depthSums : lights_->buffer(), lights_->buffer(), hardWeights_->buffer()});
        recorder.dispatch(kernels_.feather, threadsOf(region.sizePx),
                          shared::FeatherPush{.size = sizePx, .firstPx = region.firstPx},
                          {*hardWeights_, weights_->buffer()});
    }
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return ReprojectedPicture{&*lights_, &*weights_};
}

}  // namespace macula::hybrid
