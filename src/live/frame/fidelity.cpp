#include "live/frame/fidelity.h"

namespace macula::live {

namespace {

void addModel(const FrameShown& frame, std::vector<Text>& because) {
    if (!frame.foveaAgeMs) {
        because.push_back(Text("preview only"));
    } else {
        because.push_back(Text("preview around the sharp centre"));
        because.push_back(Text("sharp centre traced {:.1f} s ago with {} samples", *frame.foveaAgeMs / 1000.0,
                               frame.foveaSamples));
    }
    if (frame.picture == OnScreen::estimate) because.push_back(Text("estimated from the values"));
    if (frame.greyFacesAreCoarse) because.push_back(Text("values on cut faces only coarsely"));
}

bool isNotFit(const hybrid::ModelNews& model) {
    using hybrid::ModelStage;
    const bool isBegun = model.stage == ModelStage::resuming || model.stage == ModelStage::learning ||
                         model.stage == ModelStage::resting;
    return isBegun && !hybrid::isFitToBeShown(model);
}

}  // namespace

Fidelity fidelityOf(const FrameShown& frame) {
    Fidelity fidelity{.isFinal = frame.picture == OnScreen::traced && frame.stage == Stage::converged};
    std::vector<Text>& because = fidelity.because;
    if (isOfSplats(frame.picture)) addModel(frame, because);
    if (frame.picture == OnScreen::preview && isNotFit(frame.model))
        because.push_back(Text("the preview is not sharp enough after {} steps", frame.model.steps));
    if (frame.picture == OnScreen::fading) because.push_back(Text("preview fades out"));
    if (frame.mixesModel) because.push_back(Text("preview where it is less noisy"));
    if (frame.scale > 1) because.push_back(Text("1/{} of the pixels each way", frame.scale));
    if (!isOfSplats(frame.picture) && frame.stage != Stage::converged)
        because.push_back(Text("{} of {} samples", frame.samplesPerPixel, frame.sampleLimit));
    if (!frame.messages.empty()) because.push_back(Text("less than the full resolution"));
    if (frame.denoised) because.push_back(Text("denoised"));
    if (frame.samplesLeftOut > 0) because.push_back(Text("{} samples left out", frame.samplesLeftOut));
    return fidelity;
}

}  // namespace macula::live
