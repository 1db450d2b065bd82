#include "pipeline/trace/pixel_layers.h"

#include <algorithm>

#include "pipeline/gpu/recorder.h"
#include "pipeline/trace/guides.h"

namespace macula::trace {

Result<gpu::Buffer> findLayers(const std::shared_ptr<gpu::Device>& device, const SceneView& scene,
                               const gpu::Kernel& kernel, int width, int height) {
    const std::uint64_t pixels = std::uint64_t(width) * std::uint64_t(height);
    MACULA_TRY(
        gpu::Buffer found,
        gpu::Buffer::create(device, {.label = "layers", .bytes = pixels * sizeof(shared::PixelLayers)}));
    const int rows = rowsToMarchAtOnce(*device, width, height);
    shared::LayersPush push{};
    for (; push.firstRow < height; push.firstRow += rows) {
        MACULA_TRY(auto recorder, gpu::Recorder::create(device, "layers"));
        std::vector<gpu::Binding> bindings = scene.bindings();
        bindings.emplace_back(found);
        recorder.dispatch(kernel,
                          {static_cast<std::uint32_t>(width),
                           static_cast<std::uint32_t>(std::min(rows, height - push.firstRow))},
                          push, bindings);
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    }
    return found;
}

}  // namespace macula::trace
