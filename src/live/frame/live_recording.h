// The live picture without a window: the same render thread, in real time, for a camera that follows a path,
// and for a drawing that changes when it has come to rest.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/timeline.h"
#include "live/frame/frame_input.h"
#include "live/frame/render_events.h"
#include "live/frame/scene_keeper.h"
#include "scene/camera/camera_path.h"

namespace macula::app {

struct RecordingOptions {
    glm::ivec2 sizePx{1280, 720};
    // The way of the camera. Nothing: what is seen fills the picture, from `from`, and the camera goes around
    // it, one turn in `turnS`, for `movingS`; 0: it stands still.
    std::optional<CameraPath> path;
    std::optional<ViewDirection> from = {};  // nothing: usualView
    bool isParallel = false;                 // of a camera that is made here
    double turnS = 60.0;
    double movingS = 10.0;
    double learningS = 5.0;     // from the first traced picture on, before a hand begins to move the camera
    double restingS = 10.0;     // after it has let go, at least until the last view is shown
    double picturesPerS = 2.0;  // that are kept, at most; besides, the last one
    std::string device;         // as gpu::DeviceOptions::preferred
    std::shared_ptr<SceneKeeper> keeper;  // of models of earlier runs; null: none
    // What is drawn after that, from where the camera is, for as long again; another than the scene's.
    std::optional<Drawing> thenDrawing;
};

enum class RecordingPhase { opening, moving, resting, changed };
// The name as in reports; a literal.
std::string_view nameOf(RecordingPhase phase);

// What the render thread was told. FrameShown::inputSequence counts them, from 1.
struct RecordedInput {
    double atS = 0.0;  // when it was published, since the volume was handed over
    RecordingPhase phase = RecordingPhase::opening;
    Camera camera;
};

struct RecordedFrame {
    double atS = 0.0;  // since the volume was handed over
    RecordingPhase phase = RecordingPhase::opening;
    Camera camera;
    FrameShown shown;
    glm::ivec2 sizePx{0};           // of `rgba`: that which a window would scale
    std::vector<glm::u8vec4> rgba;  // row 0 on top; empty: not kept
};

// The renderer said that what is wanted is not there yet: Preparing, PictureRemoved, DeviceRestarting.
struct RecordedNotice {
    double atS = 0.0;  // likewise
    std::string what;  // for a person
};

// Where the time of the render thread went in a phase, to a quarter of a second or so.
struct RecordedTimes {
    RecordingPhase phase = RecordingPhase::opening;
    double watchedS = 0.0;
    std::vector<StageTimes> stages;
};

// Each list is in order of time.
struct LiveRecording {
    std::string device;
    std::vector<RecordedInput> inputs;
    std::vector<RecordedFrame> frames;
    std::vector<RecordedNotice> notices;
    std::vector<RecordedTimes> times;
    double seconds = 0.0;  // from when the volume was handed over to the end
    // Pictures were left out because of their number.
    bool isFull = false;
};

// Memory for pictures that are kept.
inline constexpr std::uint64_t kMostRecordedBytes = std::uint64_t(1) << 30;

// `scene`: volume, drawing and what else a picture is of; its camera, place and size are set here.
// `cancelled`; and what the renderer fails with.
Result<LiveRecording> recordLive(FrameInput scene, const RecordingOptions& options, Progress& progress);

}  // namespace macula::app
