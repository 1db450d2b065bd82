// One view of a scene: its block of parameters, and the scene's tables, as kernels read them.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/settings.h"

namespace macula::trace {

// One of many views of the same scene: it has its own block of parameters, and everything else belongs to the
// scene. Used by one thread at a time, the one that uses the device.
class SceneView {
  public:
    static Result<SceneView> create(std::shared_ptr<DeviceScene> scene);

    const std::shared_ptr<DeviceScene>& shared() const { return scene_; }
    DeviceScene& scene() { return *scene_; }
    const DeviceScene& scene() const { return *scene_; }

    // Sets the view and its settings. When the scene is complete. Work submitted before still reads the
    // earlier parameters.
    Result<void> look(const View& view, const Settings& settings);
    const shared::TraceParams& params() const { return looked_; }  // as look() made them
    // Whether the scene has not changed since the last look().
    bool isCurrent() const { return edition_ == scene_->edition(); }

    // While it is current: bindings 0 to 15 of shaders/trace/host.glsl.
    std::vector<gpu::Binding> bindings() const;

  private:
    SceneView(std::shared_ptr<DeviceScene> scene, gpu::Buffer params)
        : scene_(std::move(scene)), params_(std::move(params)) {}

    std::shared_ptr<DeviceScene> scene_;
    gpu::Buffer params_;
    shared::TraceParams looked_{};
    std::uint64_t edition_ = UINT64_MAX;  // of the scene, at the last look()
};

}  // namespace macula::trace
