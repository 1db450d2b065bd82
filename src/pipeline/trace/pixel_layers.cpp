#include "pipeline/trace/pixel_layers.h"

#include <algorithm>

#include "pipeline/gpu/recorder.h"
#include "pipeline/trace/portions.h"

namespace macula::trace {

Result<void> findLayers(const std::shared_ptr<gpu::Device>& device, const SceneView& scene,
                        const gpu::Kernel& kernel, int width, int height,
                        std::optional<gpu::Buffer>& layers) {
    const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
    const std::uint64_t bytes = pixels * sizeof(shared::PixelLayers);
    if (!layers || layers->bytes() != bytes) {
        layers.reset();  // first: there may be no room for both
        MACULA_TRY(layers, gpu::Buffer::create(device, {.label = "layers", .bytes = bytes}));
    }
    const int rows = rowsToMarchAtOnce(device->isCpu(), width, height);
    shared::LayersPush push{};
    for (; push.firstRow < height; push.firstRow += rows) {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "layers"));
        std::vector<gpu::Binding> bindings = scene.bindings();
        bindings.emplace_back(*layers);
        recorder.dispatch(kernel,
                          {static_cast<std::uint32_t>(width),
                           static_cast<std::uint32_t>(std::min(rows, height - push.firstRow))},
                          push, bindings);
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    }
    return {};
}

}  // namespace macula::trace
