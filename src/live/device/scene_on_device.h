// The scene that models are trained on and judged by, and a tracer that holds it.
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

namespace macula::live {

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
    bool isCoarse = false;    // some voxels are coarse on the device: its pictures are no ground truth
    std::vector<Text> notes;  // sentences on what is coarse
};

// Both fail with inputNotUsable if nothing of the scene is visible. visibleScene needs no device.
Result<hybrid::TracedScene> visibleScene(const StudyScene& scene);
Result<SceneOnDevice> putOnDevice(const std::shared_ptr<gpu::Device>& device, const StudyScene& scene);

}  // namespace macula::live
