#include "pipeline/hybrid/light/lit_view.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/hybrid/light/light_slots.h"
#include "pipeline/trace/portions.h"
#include "shaders/hybrid.h"
#include "shared/pixel_layers.h"

namespace macula::hybrid {

namespace {

constexpr double kFarthest = LightInSpace::kFarthest;

}  // namespace

int raysAside(const glm::ivec2& sizePx) {
    constexpr std::uint64_t kMostBytes = std::uint64_t(64) << 20;
    const std::uint64_t pixels = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y);
    return 4 * pixels * sizeof(shared::PixelLayers) <= kMostBytes ? 2 : 1;
}

Result<LightTable> LightTable::create(const std::shared_ptr<gpu::Device>& device, const LightInSpace& light) {
    const LightSlots table(light);
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device, shaders::hybrid_lit_comp));
    MACULA_TRY(gpu::Buffer slots,
               gpu::Buffer::create(device, {.label = "slots of light", .bytes = table.slots().size_bytes()}));
    MACULA_TRY(gpu::TexelBuffer cells,
               gpu::TexelBuffer::create(device, {.label = "cells of light",
                                                 .elements = table.cells().size(),
                                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT}));
    MACULA_TRY_VOID(gpu::uploadTo(slots, table.slots()));
    MACULA_TRY_VOID(gpu::uploadTo(cells.buffer(), table.cells()));
    return LightTable(std::move(kernel), std::move(slots), std::move(cells), light.cellMm());
}

shared::LitPush LightTable::pushFor(const CameraBasis& eye, const Camera& camera,
                                    const glm::ivec2& sizePx) const {
    const double half = std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
    const glm::dvec3 eyeAt = camera.positionMm / cellMm_;
    // An eye farther away sees no cell of the cache.
    const glm::dvec3 eyeCell = glm::clamp(glm::floor(eyeAt), -kFarthest, kFarthest);
    return {.right = eye.right * (half * sizePx.x / sizePx.y),
            .up = eye.up * half,
            .forward = eye.forward,
            .eyeCell = glm::ivec3(eyeCell),
            .eyePart = eyeAt - eyeCell,
            .cellsPerMm = float(1.0 / cellMm_),
            .size = sizePx,
            .raysAside = raysAside(sizePx),
            .firstRow = 0,
            .slotMask = static_cast<std::uint32_t>(slots_.bytes() / sizeof(shared::LightSlot) - 1)};
}

Result<void> LightTable::begin(trace::PathTracer& tracer, const Camera& camera, const glm::ivec2& sizePx,
                               LitPicture& picture) {
    if (isParallel(camera))
        return Error{ErrorCode::usage,
                     Text("Light is learnt from what an eye sees, not from parallel rays."),
                     {},
                     Text("Take a camera that is not parallel.")};
    MACULA_TRY(const CameraBasis eye, basis(camera));
    shared::LitPush push = pushFor(eye, camera, sizePx);
    const int side = push.raysAside;
    MACULA_TRY_VOID(tracer.setView({.camera = camera, .width = side * sizePx.x, .height = side * sizePx.y}));
    MACULA_TRY_VOID(tracer.findLayersIn(layers_));
    const auto& device = layers_->device();
    const std::uint64_t bytes = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y) * sizeof(glm::vec4);
    if (!pixels_ || pixels_->bytes() != bytes) {
        MACULA_TRY(pixels_, gpu::Buffer::create(device, {.label = "lit picture", .bytes = bytes}));
    }
    const int rows = trace::rowsToMarchAtOnce(device->isCpu(), sizePx.x, sizePx.y);
    for (; push.firstRow < sizePx.y; push.firstRow += rows) {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "light a view"));
        recorder.dispatch(kernel_,
                          {static_cast<std::uint32_t>(sizePx.x),
                           static_cast<std::uint32_t>(std::min(rows, sizePx.y - push.firstRow))},
                          push, {*layers_, slots_, cells_, *pixels_});
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    }
    picture.camera_ = camera;
    picture.sizePx_ = sizePx;
    return picture.reading_.begin({&*pixels_});
}

TracedView LitPicture::view() const {
    const auto pixels = reading_.part<glm::vec4>(0);
    return {.camera = camera_, .sizePx = sizePx_, .rgba = {pixels.begin(), pixels.end()}, .isLit = true};
}

Result<TracedView> LightTable::lit(trace::PathTracer& tracer, const Camera& camera,
                                   const glm::ivec2& sizePx) {
    LitPicture picture;
    MACULA_TRY_VOID(begin(tracer, camera, sizePx, picture));
    MACULA_TRY_VOID(picture.finish());
    return picture.view();
}

}  // namespace macula::hybrid
