// A headset that does what a test says: an OpenXR 1.0 runtime without hardware, whose time goes on by one
// frame for each xrWaitFrame. It is a shared library, found by the loader through a manifest
// (XR_RUNTIME_JSON); a test links it besides, and says here what head, eyes and hands do.
//
// It checks what an application calls: the order of calls, and that structures, spaces, swapchains and layers
// are those of the session. What is wrong is noted, and where the standard has a code for it, answered.
//
// A program that is run from outside takes MACULA_XR_SCRIPT, words between commas: no-headset, no-vulkan2,
// newer-vulkan, no-gaze, no-layers, depth, mask, insets, room, see-through; paced, no-pictures, and numbers:
// rate=30, eye=1024x1024.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <string>
#include <vector>

#define MACULA_XR_SCRIPT_EXPORT __attribute__((visibility("default")))

namespace macula::xr_script {

// Metres, in the stage: +x right, +y up, -z ahead of who stands in its middle.
struct Pose {
    glm::dvec3 positionM{0.0};
    glm::dquat orientation{1.0, 0.0, 0.0, 0.0};
};

// Angles in rad, as XrFovf: left and down are below 0 in most headsets.
struct Field {
    float left = -0.6f;
    float right = 0.6f;
    float up = 0.6f;
    float down = -0.6f;
};

struct Hand {
    Pose pose;
    float squeeze = 0.0f;  // 0 to 1; of a simple controller its select button
    float trigger = 0.0f;  // likewise, its menu button
    bool isTracked = true;
    float stick = 0.0f;            // -1 to 1, of a stick or a pad, to the right
    bool isPadPressed = false;     // of a pad
    std::optional<Pose> aim = {};  // nothing: as the pose
};

// Without a controller: how far its finger tips are from the tip of the thumb.
struct BareHand {
    Pose palm;
    double indexApartM = 0.1;
    double middleApartM = 0.1;
};

struct Script {
    bool hasHeadset = true;
    bool offersVulkan2 = true;
    bool needsNewerVulkan = false;  // than there is
    std::string lacks;              // the name of a function that it does not have
    bool offersGaze = true;
    bool takesLayers = true;    // swapchains of two array layers
    bool hasStage = true;       // a STAGE space
    bool offersDepth = false;   // XR_KHR_composition_layer_depth, and D32_SFLOAT for it
    bool offersMask = false;    // XR_KHR_visibility_mask: `hidden`
    bool offersInsets = false;  // XR_VARJO_quad_views
    // XrEnvironmentBlendMode: 1 opaque, 2 additive, 3 alpha blend; the first is preferred.
    std::vector<int> blendModes{1};
    // Triangles, three corners each, as tangents; the same for all views.
    std::vector<glm::dvec2> hidden;
    glm::uvec2 insetPx{48, 48};
    std::array<Field, 2> insetFields{Field{-0.2f, 0.2f, 0.2f, -0.2f}, Field{-0.2f, 0.2f, 0.2f, -0.2f}};
    // Frames come at times of the clock, as those of a real headset do: who is late misses some.
    bool isPaced = false;
    bool keepsPictures = true;       // false: what is submitted is checked, and its pixels are not read
    bool lendsUnknownImage = false;  // says of an image that is not there that it is lent
    bool offersHands = false;        // XR_EXT_hand_tracking
    bool offersReverb = false;       // XR_EXT_hp_mixed_reality_controller
    std::string controllers = "/interaction_profiles/oculus/touch_controller";  // that hands hold
    glm::uvec2 eyePx{64, 64};
    double framesPerS = 30.0;
    std::array<Field, 2> fields{};
    double eyesApartM = 0.064;
    std::function<Pose(double seconds)> head;  // empty: stands still
    // How far off the head is foreseen to be, to its right, when it is asked for so many times before in the
    // same frame; empty: it is foreseen as it will be.
    std::function<double(int asked)> foreseenAsideM;
    std::function<std::optional<Pose>(double seconds)> gaze;                    // empty: straight ahead
    std::function<std::optional<Hand>(double seconds, int hand)> hand;          // 0: left; empty: none
    std::function<std::optional<BareHand>(double seconds, int hand)> bareHand;  // likewise
    std::function<bool(double seconds)> isTracked;          // empty: the head's place is always seen
    std::function<bool(std::uint64_t frame)> shouldRender;  // empty: always
    // The `nth` call of that name, from 1, and all of the session or instance after it, are answered
    // with `answer`, an XrResult: XR_ERROR_SESSION_LOST or XR_ERROR_INSTANCE_LOST.
    std::string loseAt;
    int loseNth = 1;
    int answer = 0;
};

// What was chained to a view.
struct SubmittedDepth {
    glm::ivec2 sizePx{0};
    float minDepth = 0.0f;
    float maxDepth = 1.0f;
    float nearM = 0.0f;
    float farM = 0.0f;
    std::vector<float> depths;  // row 0 on top
};

struct SubmittedView {
    Pose pose;
    Field field;
    glm::ivec2 sizePx{0};
    std::vector<glm::u8vec4> rgba;  // as it lies in the image, sRGB encoded, row 0 on top
    std::optional<SubmittedDepth> depth;
};

// A flat layer in the stage.
struct SubmittedQuad {
    Pose pose;
    glm::dvec2 sizeM{0.0};
    glm::ivec2 sizePx{0};
    std::vector<glm::u8vec4> rgba;  // alpha is straight
};

// Felt in a hand.
struct FeltPulse {
    int hand = 0;  // 0: left
    float strength = 0.0f;
    double ms = 0.0;
};

struct SubmittedFrame {
    std::uint64_t number = 0;          // of the frame, from 0
    double seconds = 0.0;              // when it is to be displayed
    std::vector<SubmittedView> views;  // of eyes, then of insets; none: nothing was shown
    std::vector<SubmittedQuad> quads;
    int blendMode = 1;
    bool usesAlpha = false;  // of the layer for the eyes
};

struct Record {
    std::vector<std::string> violations;
    std::vector<SubmittedFrame> frames;  // the last kMostFrames of them
    std::uint64_t waited = 0;            // calls of xrWaitFrame
    std::uint64_t begun = 0;             // and so on
    std::uint64_t ended = 0;
    std::uint64_t missed = 0;  // times of a paced headset for which there was no frame
    std::vector<FeltPulse> pulses;
    std::vector<std::string> profiles;  // bindings of which were suggested and taken
    int instances = 0;                  // that there are now
    int sessions = 0;
    int swapchains = 0;
    int spaces = 0;
    int actionSets = 0;
    int handTrackers = 0;
};
inline constexpr std::size_t kMostFrames = 64;

// Holds for what is created from now on, and for poses at once. Forgets the record.
MACULA_XR_SCRIPT_EXPORT void follow(Script script);
MACULA_XR_SCRIPT_EXPORT Record record();
// The person takes the headset off: the runtime asks the application to end.
MACULA_XR_SCRIPT_EXPORT void requestEnd();
// Lenses show something else from now on (`hidden` of the script): the application is told.
MACULA_XR_SCRIPT_EXPORT void changeMask(std::vector<glm::dvec2> hidden);
// The person recentres the space that the application uses: it is another one from so many seconds after the
// last frame on.
MACULA_XR_SCRIPT_EXPORT void recentre(double inSeconds = 0.0);

}  // namespace macula::xr_script
