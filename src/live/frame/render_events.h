// What the render thread reports, as values. It reports on its own thread; whoever listens hands them on.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/message.h"
#include "base/result.h"
#include "base/timeline.h"
#include "live/frame/picture_course.h"
#include "pipeline/hybrid/model/model_news.h"
#include "pipeline/hybrid/model/peripheral_state.h"
#include "pipeline/splat/model/splats.h"
#include "pipeline/trace/look.h"
#include "scene/camera/orbit_camera.h"

namespace macula::app {

struct DeviceReady {
    std::string name;           // for people
    std::string description;    // one line with type, memory and driver
    bool isFirstStart = false;  // gpu::Device::isFirstStart: the first pictures take some seconds longer
};

// The device stopped responding. Another one is being started, and what was shown is made anew.
struct DeviceRestarting {};

// Some seconds may pass: a volume is being brought to the device.
struct Preparing {
    std::string what;  // "Preparing the volume". No patient data.
};

enum class Stage {
    moving,      // a picture that follows the hand
    converging,  // traced with all pixels, not yet all samples
    converged,   // nothing more will change
};

// The peripheral model has come further, or there is none any more.
struct ModelChanged {
    std::uint64_t study = 0;
    hybrid::ModelNews model{};
};

// The peripheral model that was asked for: FrameInput::modelWishes.
struct ModelTaken {
    std::uint64_t wish = 0;
    std::shared_ptr<const splat::Splats> splats{};           // null: there is none of what is wanted now
    double gain = 1.0;                                       // as hybrid::LiveModel::gain
    std::shared_ptr<const hybrid::PeripheralState> state{};  // null: not asked for, or nothing was learnt
    std::optional<Error> error{};                            // it could not be read: nothing else is there
};

// What can be seen of the matter, found anew after each change of volume, preset or clip: its outline.
struct OutlineFound {
    std::uint64_t study = 0;
    std::shared_ptr<const std::vector<glm::dvec3>> pointsMm;  // see trace::PathTracer::outlineMm
};

// A picture was shown.
struct FrameShown {
    std::uint64_t inputSequence = 0;       // of the input it was made from
    std::uint64_t study = 0;               // likewise; whose picture it is
    EdgeLetters letters{};                 // where the sides of the patient are in it
    Camera camera{};                       // that it was seen by
    OnScreen picture = OnScreen::nothing;  // which kind
    Stage stage = Stage::moving;
    int width = 0;  // of what was drawn; the window's, divided by `scale`
    int height = 0;
    int scale = 1;
    hybrid::ModelNews model{};
    std::optional<double> foveaAgeMs{};  // over the model; nothing where there was no fovea yet
    std::uint32_t foveaSamples = 0;      // of each of its pixels
    double foveaShare = 0.0;             // of the pixels, at most
    bool greyFacesAreCoarse = false;     // of a clip, by splats
    bool mixesModel = false;             // traced, but for where splats have less noise
    std::uint64_t samplesPerPixel = 0;   // on average: noise decides where they go
    std::uint64_t sampleLimit = 0;
    double noise = 0.0;        // estimated standard error of what is shown; +infinity before it is known
    double noiseTarget = 0.0;  // FrameInput::noiseTarget
    bool denoised = false;     // filtered: smooth, and not quite what was traced
    trace::Look look{};
    std::string remarks{};             // of the drawing it was made from
    double framesPerSecond = 0.0;      // of pictures shown lately; 0 when there was only one
    double latencyMs = 0.0;            // from publishing the input to showing this picture
    std::uint64_t samplesLeftOut = 0;  // not finite, or of paths too long for the device
    std::vector<Message> messages{};   // what a person has to know about it
};

// What was shown is off the screen, and nothing is shown for now.
struct PictureRemoved {};

// Nothing more is shown until something changes. What was shown has been taken off the screen, unless
// `pictureRemains`: then the device could not do that yet, or never will, and who owns the window hides it.
struct RenderFailure {
    Error error;
    std::uint64_t inputSequence = 0;  // of the newest input then
    bool pictureRemains = false;
};

// Where the time of the render thread went, since it began. It tells that a few times a second while it
// works. In the rest of its time, which no stage has, it waited for an input.
struct TimeSpent {
    std::vector<StageTimes> stages;
};

using RenderEvent = std::variant<DeviceReady, DeviceRestarting, Preparing, ModelChanged, OutlineFound,
                                 FrameShown, PictureRemoved, RenderFailure, ModelTaken, TimeSpent>;
using RenderListener = std::function<void(RenderEvent)>;

}  // namespace macula::app
