#include "live/frame/applied_scene.h"

#include <utility>
#include <vector>

#include "pipeline/trace/device_scene.h"

namespace macula::live {

namespace {

bool isSameMatter(const std::optional<std::shared_ptr<const Additions>>& applied,
                  const std::shared_ptr<const Additions>& wanted) {
    static const Additions kNone;
    return applied && macula::isSameMatter(*applied ? **applied : kNone, wanted ? *wanted : kNone);
}

}  // namespace

bool AppliedScene::hasOtherMatter(const FrameInput& input) const {
    const scene::Drawing& drawing = input.drawing;
    return parts_.volume != input.volume || parts_.clip != drawing.clip ||
           parts_.additions != drawing.additions || parts_.transferFunction != drawing.transferFunction;
}

void AppliedScene::distrust() {
    parts_.volume = nullptr;
    parts_.transferFunction = nullptr;
    parts_.lights = nullptr;
    parts_.clip.reset();
}

Result<bool> AppliedScene::apply(const FrameInput& input, TracedPictures& traced,
                                 const std::function<bool()>& interrupted) {
    const scene::Drawing& drawing = input.drawing;
    if (parts_.volume != input.volume) {
        MACULA_TRY_VOID(setVolume(input, traced));
        if (interrupted()) return false;
    }
    // Before the transfer function, so that hidden voxels are not brought to the device.
    if (parts_.clip != drawing.clip) {
        MACULA_TRY_VOID(setClip(input, traced));
        if (interrupted()) return false;
    }
    if (parts_.additions != drawing.additions) {
        MACULA_TRY_VOID(setAdditions(input, traced));
        if (interrupted()) return false;
    }
    if (parts_.transferFunction != drawing.transferFunction) {
        MACULA_TRY_VOID(setTransferFunction(input, traced));
        if (interrupted()) return false;
    }
    if (parts_.lights != drawing.lights) MACULA_TRY_VOID(setLights(input, traced));
    if (outlineOf_ != input.study) MACULA_TRY_VOID(reportOutline(input, traced));
    return true;
}

Result<void> AppliedScene::setVolume(const FrameInput& input, TracedPictures& traced) {
    reports_.tell(Preparing{Text("Preparing the volume")});
    traced.sceneChanged();
    outlineOf_.reset();
    parts_.volume = nullptr;
    parts_.transferFunction = nullptr;
    parts_.additions = nullptr;
    MACULA_TRY_VOID(traced.tracer().scene().setVolume(input.volume));
    parts_.volume = input.volume;
    return {};
}

Result<void> AppliedScene::setClip(const FrameInput& input, TracedPictures& traced) {
    reportPreparing();
    traced.sceneChanged();
    outlineOf_.reset();
    parts_.clip.reset();
    MACULA_TRY_VOID(traced.tracer().scene().setClip(input.drawing.clip ? *input.drawing.clip : Clip{}));
    parts_.clip = input.drawing.clip;
    return {};
}

Result<void> AppliedScene::setAdditions(const FrameInput& input, TracedPictures& traced) {
    const std::shared_ptr<const Additions>& additions = input.drawing.additions;
    traced.sceneChanged();
    // Other segments, or other colours of them, take little time and change no outline.
    if (!isSameMatter(parts_.additions, additions)) {
        reportPreparing();
        outlineOf_.reset();
    }
    parts_.additions.reset();
    MACULA_TRY_VOID(traced.tracer().scene().setAdditions(additions ? *additions : Additions{}));
    parts_.additions = additions;
    return {};
}

Result<void> AppliedScene::setTransferFunction(const FrameInput& input, TracedPictures& traced) {
    reportPreparing();
    traced.sceneChanged();
    outlineOf_.reset();
    parts_.transferFunction = nullptr;
    MACULA_TRY_VOID(traced.tracer().scene().setTransferFunction(*input.drawing.transferFunction));
    parts_.transferFunction = input.drawing.transferFunction;
    return {};
}

Result<void> AppliedScene::setLights(const FrameInput& input, TracedPictures& traced) {
    traced.sceneChanged();
    parts_.lights = nullptr;
    MACULA_TRY_VOID(
        traced.tracer().scene().setEnvironment(trace::Environment::fromRig(*input.drawing.lights)));
    parts_.lights = input.drawing.lights;
    return {};
}

Result<void> AppliedScene::reportOutline(const FrameInput& input, TracedPictures& traced) {
    MACULA_TRY(std::vector<glm::dvec3> outline, traced.tracer().outlineMm());
    reports_.tell(
        OutlineFound{.study = input.study,
                     .pointsMm = std::make_shared<const std::vector<glm::dvec3>>(std::move(outline)),
                     .phase = input.phase});
    outlineOf_ = input.study;
    return {};
}

// Silent until a transfer function is applied: before, "Preparing the volume" still holds.
void AppliedScene::reportPreparing() const {
    if (parts_.transferFunction) reports_.tell(Preparing{Text("Preparing what is shown")});
}

}  // namespace macula::live
