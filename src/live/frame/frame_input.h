// The input of the render thread, as one value.
#pragma once

#include <chrono>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/camera.h"
#include "base/volume.h"
#include "live/frame/picture_text.h"
#include "live/frame/screen.h"
#include "pipeline/hybrid/frame/fovea_size.h"
#include "pipeline/trace/path_tracer.h"
#include "scene/camera/orbit_camera.h"
#include "scene/drawing/drawing.h"

namespace macula::live {

// How frames in motion are made: the traced fovea over the model. Affects the noise and sharpness of a frame,
// never the simulated light.
struct LiveQuality {
    bool hasFovea = true;  // false: no new fovea is traced; an earlier traced picture is reused
    hybrid::FoveaOptions fovea{};
    double foveaMs = hybrid::kFoveaBudgetMs;  // tracing time of a fovea; less makes it smaller or coarser
    double betweenFramesMs = 12.0;            // the part of foveaMs between two frames

    bool operator==(const LiveQuality&) const = default;
};

// Noise too low to see: the standard error of the displayed picture (black to white is 1). One step of eight
// bits.
inline constexpr double kUnseenNoise = 1.0 / 255.0;

// Another phase of the study that is open, as it would be shown.
struct PhaseScene {
    std::uint64_t phase = 0;                 // see FrameInput::phase
    std::shared_ptr<const Volume> volume{};  // not null
    scene::Drawing drawing{};                // complete

    bool operator==(const PhaseScene&) const = default;
};
using PhaseScenes = std::vector<PhaseScene>;  // in the order of phases; the first follows the last

// Everything that decides what is on the screen. The UI thread publishes a whole new value after each change;
// the render thread takes the newest and compares it with the one before. A published value never changes.
struct FrameInput {
    std::uint64_t sequence = 0;  // grows by one with each input
    std::chrono::steady_clock::time_point published{};

    std::shared_ptr<const ScreenPlace> place{};  // null: release the current one
    int width = 0;                               // size of the place, in device pixels
    int height = 0;
    bool visible = false;         // false: nothing is rendered
    std::uint64_t exposures = 0;  // grows when the window system has lost the picture

    std::uint64_t study = 0;                 // grows with each volume
    std::shared_ptr<const Volume> volume{};  // null: no volume is open
    // Which phase of the study `volume` is, from 1; 0: the study is shown without phases. If this changes, a
    // study may change its volume: it is still the same patient.
    std::uint64_t phase = 0;
    bool playsPhases = false;  // phases follow each other: a learnt one is drawn as splats, and not traced
    // All phases; null: only the one that is shown is known.
    std::shared_ptr<const PhaseScenes> phases{};
    bool learnsPhases = false;  // the models of `phases` are learnt while the picture rests
    scene::Drawing drawing{};
    Camera camera{};
    scene::EdgeLetters letters{};               // for this camera; FrameShown returns them with its pictures
    std::shared_ptr<const PictureText> text{};  // over every picture of the study; null: none
    // Drawn only over pictures of this camera and size; null: none.
    std::shared_ptr<const PictureText> marks{};
    glm::vec3 background{scene::kWindowBackground};  // as displayed, in linear light: backgroundInWindow
    std::uint32_t sampleLimit = 512;                 // per pixel; then the picture counts as converged
    double noiseTarget = kUnseenNoise;               // above 0; with less noise the picture has converged
    bool convergesNow = false;                       // no training at rest: all time is for tracing
    bool interacting = false;                        // the user is moving something: frames must be fast
    glm::dvec2 gaze{0.0};   // where the user looks in the picture, -1 to 1; x right, y up
    bool usesModel = true;  // draw the peripheral model while the view moves
    LiveQuality live{};     // what is traced over the model
    // Grows with each request for the drawn model (ModelSnapshot); requestsTraining: with its training.
    std::uint64_t modelRequests = 0;
    bool requestsTraining = false;
};

// Whether the input has all that a picture needs.
inline bool isComplete(const FrameInput& input) {
    return input.volume && input.drawing.transferFunction && input.drawing.lights;
}

}  // namespace macula::live
