// What models are made of and judged by: a scene, and a tracer that has it.
#pragma once

#include <memory>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/gpu/device.h"
#include "pipeline/hybrid/traced_scene.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::cli {

struct EvaluatedScene {
    std::shared_ptr<const Volume> volume;  // stored16
    TransferFunction function;
    Clip clip;
    trace::Environment environment;
};

struct SceneOnDevice {
    hybrid::TracedScene traced;
    trace::PathTracer tracer;
    bool isCoarse = false;  // not all voxels are on the device: what is traced is no truth for others
};

// inputNotUsable when nothing of the scene can be seen. A person is told what is coarse.
Result<SceneOnDevice> putOnDevice(const std::shared_ptr<gpu::Device>& device, const EvaluatedScene& scene);

}  // namespace macula::cli
