// Reports of the render thread, as values. The listener is called on that thread, and passes them on.
#pragma once

#include <cstddef>
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

namespace macula::live {

struct DeviceReady {
    std::string name;           // for people
    std::string description;    // one line with type, memory and driver
    bool isFirstStart = false;  // gpu::Device::isFirstStart: first pictures take seconds longer
};

// The device stopped responding. The renderer starts another one, and makes the picture again.
struct DeviceRestarting {};

// The renderer prepares something that may take seconds, such as a volume for the device.
struct Preparing {
    Text what;  // "Preparing the volume". No patient data.
};

enum class Stage {
    moving,      // a picture that follows the hand
    converging,  // traced with all pixels, but not all samples
    converged,   // the picture is final
};

// The peripheral model has progressed, or there is none any more.
struct ModelChanged {
    std::uint64_t study = 0;
    hybrid::ModelNews model{};
};

// The models of phases (FrameInput::phases) have progressed.
struct PhaseModelsChanged {
    std::uint64_t study = 0;
    std::size_t learnt = 0;      // phases that can be played
    std::size_t wanted = 0;      // all phases
    std::uint64_t learning = 0;  // the phase that is learnt now; 0: none
    std::uint64_t steps = 0;     // of its training
    bool noRoom = false;         // the device has no memory for another phase beside the one that is shown

    bool operator==(const PhaseModelsChanged&) const = default;
};

// The answer to a request for the peripheral model (FrameInput::modelRequests).
struct ModelSnapshot {
    std::uint64_t request = 0;
    std::shared_ptr<const splat::Splats> splats{};           // null: the current scene has none
    double gain = 1.0;                                       // as hybrid::LiveModel::gain
    std::shared_ptr<const hybrid::PeripheralState> state{};  // null: not requested, or untrained
    std::optional<Error> error{};                            // set: reading failed, and the rest is empty
};

// The outline of the visible matter, computed after each change of volume, preset or clip.
struct OutlineFound {
    std::uint64_t study = 0;
    std::shared_ptr<const std::vector<glm::dvec3>> pointsMm;  // see trace::PathTracer::outlineMm
    std::uint64_t phase = 0;                                  // FrameInput::phase
};

// A picture was shown.
struct FrameShown {
    std::uint64_t inputSequence = 0;       // of its input
    std::uint64_t study = 0;               // of its input
    std::uint64_t phase = 0;               // of its input
    scene::EdgeLetters letters{};          // the sides of the patient in this view
    Camera camera{};                       // the camera of the picture
    OnScreen picture = OnScreen::nothing;  // kind of picture
    Stage stage = Stage::moving;
    int width = 0;  // width of the drawn picture: the window's, divided by `scale`
    int height = 0;
    int scale = 1;
    hybrid::ModelNews model{};
    std::optional<double> foveaAgeMs{};  // age of the fovea over the model; nothing without one
    std::uint32_t foveaSamples = 0;      // per pixel of the fovea
    double foveaShare = 0.0;             // largest share of the pixels that the fovea covers
    bool greyFacesAreCoarse = false;     // splats show the grey cut faces of a clip
    bool mixesModel = false;             // splats show the parts where they have less noise
    std::uint64_t samplesPerPixel = 0;   // mean; noise decides which pixels get more
    std::uint64_t sampleLimit = 0;
    double noise = 0.0;        // estimated standard error if traced; +infinity: not known yet
    double noiseTarget = 0.0;  // FrameInput::noiseTarget
    bool denoised = false;     // smoother than the traced light
    trace::Look look{};
    Text remarks{};                    // remarks of the drawing
    double framesPerSecond = 0.0;      // rate of recent pictures; 0 if there was only one
    double latencyMs = 0.0;            // from publishing the input to showing the picture
    std::uint64_t samplesLeftOut = 0;  // not finite, or of paths too long for the device
    std::vector<Message> messages{};   // for the user
};

// The picture was taken off the screen, and no other is shown for now.
struct PictureRemoved {};

// No picture follows until the input changes. The last one is off the screen, unless `pictureRemains`: then
// the device could not clear the window, and the owner of the window hides it.
struct RenderFailure {
    Error error;
    std::uint64_t inputSequence = 0;  // the newest input at that time
    bool pictureRemains = false;
};

// The time that the render thread has spent since it began, by stage. Sent a few times a second while it
// works. The time that no stage accounts for was spent waiting for input.
struct TimeSpent {
    std::vector<StageTimes> stages;
};

using RenderEvent =
    std::variant<DeviceReady, DeviceRestarting, Preparing, ModelChanged, OutlineFound, FrameShown,
                 PictureRemoved, RenderFailure, ModelSnapshot, TimeSpent, PhaseModelsChanged>;
using RenderListener = std::function<void(RenderEvent)>;

}  // namespace macula::live
