// Records the live picture without a window: the same render thread in real time, with a camera that follows
// a path, and optionally a drawing that changes once the camera rests.
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

namespace macula::live {

struct RecordingOptions {
    glm::ivec2 sizePx{1280, 720};
    // The camera's path. Nothing: the camera starts at `from`, with the visible matter filling the picture,
    // and orbits for `movingS`, one turn in `turnS`; with `movingS` 0 it stands still.
    std::optional<scene::CameraPath> path;
    std::optional<ViewDirection> from = {};  // nothing: usualView
    bool isParallel = false;                 // for the camera made without `path`
    double turnS = 60.0;
    double movingS = 10.0;
    double learningS = 5.0;               // from the first traced picture until the camera moves
    double restingS = 10.0;               // after the motion; or longer, until the last view is shown
    double picturesPerS = 2.0;            // most that are kept, besides the first and last of each rest
    std::string device;                   // as gpu::DeviceOptions::preferred
    std::shared_ptr<SceneKeeper> keeper;  // stores models between runs; null: none
    // Drawn afterwards from the last camera, for another `restingS`; must differ from the scene's drawing.
    std::optional<scene::Drawing> thenDrawing;
};

enum class RecordingPhase { opening, moving, resting, changed };
// The name as in reports; a literal.
std::string_view nameOf(RecordingPhase phase);

// An input given to the render thread. FrameShown::inputSequence counts inputs from 1.
struct RecordedInput {
    double atS = 0.0;  // when it was published, since recording began
    RecordingPhase phase = RecordingPhase::opening;
    Camera camera;
};

struct RecordedFrame {
    double atS = 0.0;  // since recording began
    RecordingPhase phase = RecordingPhase::opening;
    Camera camera;
    FrameShown shown;
    glm::ivec2 sizePx{0};           // size of `rgba`; a window would scale it
    std::vector<glm::u8vec4> rgba;  // row 0 on top; empty: not kept
};

// The renderer reported that the picture is not there yet: Preparing, PictureRemoved, DeviceRestarting.
struct RecordedNotice {
    double atS = 0.0;  // since recording began
    Text what;         // a sentence for the user
};

// How the render thread spent a phase, by stage, accurate to about a quarter of a second.
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
    double seconds = 0.0;  // from the start of the recording to its end
    // Some pictures were not kept, because kMostRecordedBytes was reached.
    bool isFull = false;
};

// Most memory that kept pictures may take.
inline constexpr std::uint64_t kMostRecordedBytes = std::uint64_t(1) << 30;

// `scene` has the volume, drawing and other inputs; its camera, place and size are set here. Fails with
// `cancelled`, and with the renderer's errors.
Result<LiveRecording> recordLive(FrameInput scene, const RecordingOptions& options, Progress& progress);

}  // namespace macula::live
