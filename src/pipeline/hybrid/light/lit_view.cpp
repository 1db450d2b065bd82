#include "pipeline/hybrid/light/lit_view.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "base/camera.h"
#include "base/check.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/guides.h"
#include "shaders/hybrid.h"
#include "shared/light_params.h"
#include "shared/pixel_layers.h"

namespace macula::hybrid {

namespace {

using shared::LightSlot;

struct Flat {
    std::vector<LightSlot> slots;
    std::vector<glm::vec4> cells;  // six for each
};

Flat flat(const LightInSpace& light) {
    Flat table;
    const LightSlot free{.low = 0, .high = shared::kFreeSlot, .cell = 0};
    table.slots.assign(std::bit_ceil(2 * light.cells() + 1), free);
    table.cells.reserve(std::max<std::size_t>(6 * light.cells(), 6));
    light.forEachCell([&](std::uint64_t key, const LightInSpace::Cell& cell) {
        std::size_t slot = LightInSpace::hashOf(key) & (table.slots.size() - 1);
        while (table.slots[slot].high != shared::kFreeSlot) slot = (slot + 1) & (table.slots.size() - 1);
        table.slots[slot] = {.low = static_cast<std::uint32_t>(key),
                             .high = static_cast<std::uint32_t>(key >> 32),
                             .cell = static_cast<std::uint32_t>(table.cells.size() / 6)};
        for (const glm::vec4& mean : cell)
            table.cells.emplace_back(glm::vec3(mean), float(LightInSpace::trust(mean.w)));
    });
    if (table.cells.empty())
        table.cells.resize(6, glm::vec4(0.0f));  // nothing was seen, and none points here
    return table;
}

}  // namespace

int raysAside(const glm::ivec2& sizePx) {
    constexpr std::uint64_t kMostBytes = std::uint64_t(64) << 20;
    const std::uint64_t pixels = std::uint64_t(sizePx.x) * std::uint64_t(sizePx.y);
    return 4 * pixels * sizeof(shared::PixelLayers) <= kMostBytes ? 2 : 1;
}

Result<LightTable> LightTable::create(const std::shared_ptr<gpu::Device>& device, const LightInSpace& light) {
    const Flat table = flat(light);
    MACULA_TRY(gpu::Kernel kernel, gpu::Kernel::create(device, shaders::hybrid_lit_comp));
    MACULA_TRY(gpu::Buffer slots,
               gpu::Buffer::create(
                   device, {.label = "slots of light", .bytes = std::span(table.slots).size_bytes()}));
    MACULA_TRY(gpu::TexelBuffer cells,
               gpu::TexelBuffer::create(device, {.label = "cells of light",
                                                 .elements = table.cells.size(),
                                                 .format = VK_FORMAT_R32G32B32A32_SFLOAT}));
    MACULA_TRY_VOID(gpu::uploadTo(slots, std::span(table.slots)));
    MACULA_TRY_VOID(gpu::uploadTo(cells.buffer(), std::span(table.cells)));
    return LightTable(std::move(kernel), std::move(slots), std::move(cells), light.cellMm());
}

Result<TracedView> LightTable::lit(trace::PathTracer& tracer, const Camera& camera,
                                   const glm::ivec2& sizePx) const {
    if (isParallel(camera))
        return Error{ErrorCode::usage,
                     "Light is learnt from what an eye sees, not from parallel rays.",
                     {},
                     "Take a camera that is not parallel."};
    MACULA_TRY(const CameraBasis eye, basis(camera));
    const int side = raysAside(sizePx);
    MACULA_TRY_VOID(tracer.setView({.camera = camera, .width = side * sizePx.x, .height = side * sizePx.y}));
    MACULA_TRY(const gpu::Buffer layers, tracer.findLayers());
    const auto& device = layers.device();
    TracedView view{.camera = camera, .sizePx = sizePx, .isLit = true};
    view.rgba.resize(std::size_t(sizePx.x) * std::size_t(sizePx.y));
    MACULA_TRY(
        const gpu::Buffer pixels,
        gpu::Buffer::create(device, {.label = "lit picture", .bytes = std::span(view.rgba).size_bytes()}));

    const double half = std::tan(glm::radians(camera.verticalFovDeg) / 2.0);
    const glm::dvec3 eyeAt = camera.positionMm / cellMm_;
    // An eye farther than that sees nothing that is kept.
    constexpr double kFarthest = LightInSpace::kFarthest;
    const glm::dvec3 eyeCell = glm::clamp(glm::floor(eyeAt), -kFarthest, kFarthest);
    shared::LitPush push{.right = eye.right * (half * sizePx.x / sizePx.y),
                         .up = eye.up * half,
                         .forward = eye.forward,
                         .eyeCell = glm::ivec3(eyeCell),
                         .eyePart = eyeAt - eyeCell,
                         .cellsPerMm = float(1.0 / cellMm_),
                         .size = sizePx,
                         .raysAside = side,
                         .firstRow = 0,
                         .slotMask = static_cast<std::uint32_t>(slots_.bytes() / sizeof(LightSlot) - 1)};
    const int rows = trace::rowsToMarchAtOnce(*device, sizePx.x, sizePx.y);
    for (; push.firstRow < sizePx.y; push.firstRow += rows) {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "light a view"));
        recorder.dispatch(kernel_,
                          {static_cast<std::uint32_t>(sizePx.x),
                           static_cast<std::uint32_t>(std::min(rows, sizePx.y - push.firstRow))},
                          push, {layers, slots_, cells_, pixels});
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    }
    MACULA_TRY_VOID(gpu::readInto(pixels, 0, std::as_writable_bytes(std::span(view.rgba))));
    return view;
}

}  // namespace macula::hybrid
