// What the render thread is told, as one value.
#pragma once

#include <chrono>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>

#include "base/camera.h"
#include "base/volume.h"
#include "live/frame/live_quality.h"
#include "live/frame/picture_text.h"
#include "live/frame/screen.h"
#include "pipeline/trace/path_tracer.h"
#include "scene/camera/orbit_camera.h"
#include "scene/drawing/drawing.h"

namespace macula::app {

// Noise that nobody sees, as the standard error of what is shown, black to white being 1: one step of eight
// bits.
inline constexpr double kUnseenNoise = 1.0 / 255.0;

// Everything that decides what is on the screen. The UI thread publishes a whole new one after each change;
// the render thread takes the newest and looks for itself what is different. Nothing in it is ever changed
// after it was published.
struct FrameInput {
    std::uint64_t sequence = 0;  // grows by one with each input
    std::chrono::steady_clock::time_point published{};

    std::shared_ptr<const ScreenPlace> place{};  // null: let go of the one you have
    int width = 0;                               // of it, in device pixels
    int height = 0;
    bool visible = false;         // nothing is made for a window that nobody sees
    std::uint64_t exposures = 0;  // grows when the window system has lost what was shown

    std::uint64_t study = 0;                 // grows with each volume
    std::shared_ptr<const Volume> volume{};  // null: nothing is open
    Drawing drawing{};
    Camera camera{};
    EdgeLetters letters{};  // at the edges for this camera; they come back with its pictures
    std::shared_ptr<const PictureText> text{};  // over every picture of the study; null: nothing
    // Over pictures of this camera and size, and over no others; null: nothing.
    std::shared_ptr<const PictureText> marks{};
    glm::vec3 background{kWindowBackground};  // as displayed, in linear light: backgroundInWindow
    std::uint32_t sampleLimit = 512;    // per pixel; then it counts as converged, if noise is not gone before
    double noiseTarget = kUnseenNoise;  // below which it is gone; above 0
    bool convergesNow = false;          // while nothing moves the model does not learn: all time is for this
    bool interacting = false;           // a hand is moving something: stay fast
    glm::dvec2 gaze{0.0};   // where the eye looks in the picture, -1 to 1; right and up are positive
    bool usesModel = true;  // draw the peripheral model while the view moves
    LiveQuality live{};     // and over it
    // Grows with each wish for the model that is drawn then (ModelTaken); with all that it learns from.
    std::uint64_t modelWishes = 0;
    bool wishesTraining = false;
};

}  // namespace macula::app
