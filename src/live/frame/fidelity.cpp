#include "live/frame/fidelity.h"

#include <nlohmann/json.hpp>

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

double share(const FrameShown& frame) {
    switch (frame.picture) {
        case OnScreen::nothing:
            return 0.0;
        case OnScreen::estimate:
        case OnScreen::model:
            return frame.foveaShare;
        case OnScreen::preview:
        case OnScreen::fading:
        case OnScreen::traced:
            return 1.0;
    }
    return 0.0;
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

nlohmann::ordered_json toJson(const FrameShown& frame) {
    const Fidelity fidelity = fidelityOf(frame);
    nlohmann::ordered_json json{{"picture", nameOf(frame.picture)},
                                {"width", frame.width},
                                {"height", frame.height},
                                {"latencyMs", frame.latencyMs},
                                {"tracedShare", share(frame)}};
    if (frame.foveaAgeMs) json["fovea"] = {{"ageMs", *frame.foveaAgeMs}, {"samples", frame.foveaSamples}};
    if (frame.picture == OnScreen::preview || frame.picture == OnScreen::fading ||
        frame.picture == OnScreen::traced) {
        json["samplesPerPixel"] = frame.samplesPerPixel;
        json["denoised"] = frame.denoised;
    }
    json["model"] = {{"stage", nameOf(frame.model.stage)},  {"origin", nameOf(frame.model.origin)},
                     {"why", describe(frame.model.origin)}, {"splats", frame.model.splats},
                     {"steps", frame.model.steps},          {"views", frame.model.views}};
    json["fidelity"] = fidelity.isFinal ? "final" : "preliminary";
    json["because"] = nlohmann::ordered_json::array();
    for (const Text& reason : fidelity.because) json["because"].push_back(reason.english());
    return json;
}

}  // namespace macula::live
