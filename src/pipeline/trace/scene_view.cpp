#include "pipeline/trace/scene_view.h"

#include <span>

#include "base/check.h"

namespace macula::trace {

Result<SceneView> SceneView::create(std::shared_ptr<DeviceScene> scene) {
    // In device memory, not upload memory, which a graphics card would read over its bus for every path.
    MACULA_TRY(gpu::Buffer params,
               gpu::Buffer::create(scene->device(),
                                   {.label = "trace params", .bytes = sizeof(shared::TraceParams)}));
    return SceneView(std::move(scene), std::move(params));
}

Result<void> SceneView::look(const View& view, const Settings& settings) {
    MACULA_TRY_VOID(scene_->makeReadyFor(settings));
    MACULA_TRY(looked_, scene_->params(view, settings));
    MACULA_TRY(auto recorder, gpu::Recorder::create(scene_->device(), "look"));
    recorder.update(params_, std::as_bytes(std::span(&looked_, 1)));
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    edition_ = scene_->edition();
    return {};
}

std::vector<gpu::Binding> SceneView::bindings() const {
    MACULA_CHECK(isCurrent());
    std::vector<gpu::Binding> bindings{params_};
    for (const gpu::Binding& binding : scene_->bindings()) bindings.push_back(binding);
    return bindings;
}

}  // namespace macula::trace
