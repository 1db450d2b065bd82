// A live picture of a study, recorded to a folder, as somebody asked for it.
#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "live/frame/live_recording.h"
#include "pictures/addition_wish.h"
#include "pictures/state_wish.h"

namespace macula::app {

// Empty: not given.
struct RecordingWish {
    std::filesystem::path path;
    std::filesystem::path folder;  // is made; or is there, and empty
    std::string series;
    StateWish state;     // its camera is where the motion begins
    std::string lights;  // a built-in name
    AdditionWish additions;
    dicom::ScanOptions how;
    std::filesystem::path cameraPath;  // camera_path.h; counts more than any other camera
    std::string size = "1280x720";
    std::optional<std::filesystem::path> sessions;  // where models are kept between runs; nothing: nowhere
    RecordingOptions recording;
};

// Writes frames.jsonl, a line for each frame that was shown, times.json (timesOf), and frame-0001.png and so
// on for frames that were kept. `warn` hears what changes what is seen, `note` the rest.
using Hears = std::function<void(const std::string&)>;
Result<LiveRecording> recordStudy(const RecordingWish& wish, const Hears& note, const Hears& warn,
                                  Progress& progress);

// Where the time of the render thread went: a list of {phase, seconds, stages}, stages as in times_report.h.
nlohmann::ordered_json timesOf(const LiveRecording& recording);
std::string timesText(const LiveRecording& recording);  // for a person

// Of the frames in motion: how many a second, how late they were (median and 95th percentile), how many
// had a fovea, and how many were small pictures because the model was not fit to be shown yet.
struct MotionFigures {
    double framesPerSecond = 0.0;
    double latencyMs = 0.0;
    double lateMs = 0.0;
    std::size_t frames = 0;
    std::size_t withFovea = 0;
    std::size_t beforeModel = 0;
};
MotionFigures motionFigures(const LiveRecording& recording);
// A line for a person; with what to do where the model came too late for any fovea.
std::string textOf(const MotionFigures& figures);

}  // namespace macula::app
