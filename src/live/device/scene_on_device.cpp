#include "live/device/scene_on_device.h"
#include "pipeline/trace/device_scene.h"

#include <utility>

namespace macula::live {

Result<hybrid::TracedScene> visibleScene(const StudyScene& scene) {
    MACULA_TRY(hybrid::TracedScene traced,
               hybrid::TracedScene::create(scene.volume, scene.function, scene.clip, scene.environment,
                                           scene.additions));
    if (!(traced.seenMm().low.x <= traced.seenMm().high.x))
        return Error{ErrorCode::inputNotUsable,
                     Text("Nothing of the series can be seen."),
                     {},
                     Text("Choose another preset or clip.")};
    return traced;
}

Result<SceneOnDevice> putOnDevice(const std::shared_ptr<gpu::Device>& device, const StudyScene& scene) {
    MACULA_TRY(hybrid::TracedScene traced, visibleScene(scene));
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.scene().setVolume(scene.volume));
    MACULA_TRY_VOID(tracer.scene().setClip(scene.clip));
    MACULA_TRY_VOID(tracer.scene().setAdditions(scene.additions));
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(scene.function));
    MACULA_TRY_VOID(tracer.scene().setEnvironment(scene.environment));
    MACULA_TRY(const trace::Statistics statistics, tracer.statistics());
    SceneOnDevice onDevice{.traced = std::move(traced),
                           .tracer = std::move(tracer),
                           .isCoarse = statistics.voxels.coarseBlocks > 0};
    for (const Message& message : statistics.messages) onDevice.notes.push_back(message.sentence);
    return onDevice;
}

}  // namespace macula::live
