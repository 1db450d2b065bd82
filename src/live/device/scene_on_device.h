// What models are made of and judged by: a scene, and a tracer that has it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/views/traced_scene.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::app {

struct StudyScene {
    std::shared_ptr<const Volume> volume;  // stored16
    TransferFunction function;
    Clip clip;
    trace::Environment environment;
    Additions additions = {};
};

struct SceneOnDevice {
    hybrid::TracedScene traced;
    trace::PathTracer tracer;
    bool isCoarse = false;  // not all voxels are on the device: what is traced is no truth for others
    std::vector<std::string> notes;  // of what is coarse
};

// Both: inputNotUsable when nothing of the scene can be seen. The first needs no device.
Result<hybrid::TracedScene> visibleScene(const StudyScene& scene);
Result<SceneOnDevice> putOnDevice(const std::shared_ptr<gpu::Device>& device, const StudyScene& scene);

}  // namespace macula::app
