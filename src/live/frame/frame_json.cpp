#include "live/frame/frame_json.h"

#include "live/frame/fidelity.h"

namespace macula::live {

namespace {

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
