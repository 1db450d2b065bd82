// Records the live rendering of a study to a folder, as command-line options ask for it.
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
#include "pictures/addition_request.h"
#include "pictures/state_request.h"

namespace macula::pictures {

// Empty fields: not given.
struct RecordingRequest {
    std::filesystem::path path;
    std::filesystem::path folder;  // created if it is missing; otherwise it must be empty
    std::string series;
    StateRequest state;  // its camera is the start of the motion
    std::string lights;  // a built-in name
    AdditionRequest additions;
    dicom::ScanOptions how;
    std::filesystem::path cameraPath;  // camera_path.h; overrides any other camera
    std::string size = "1280x720";
    std::optional<std::filesystem::path> sessions;  // folder for models kept between runs; nothing: not kept
    live::RecordingOptions recording;
};

// Writes frames.jsonl with one line per shown frame, times.json (timesOf), and frame-0001.png and so on for
// kept frames. `warn` receives notes that affect what is seen, `note` the others.
using Hears = std::function<void(const Text&)>;
Result<live::LiveRecording> recordStudy(const RecordingRequest& request, const Hears& note, const Hears& warn,
                                        Progress& progress);

// Time use of the render thread: a list of {phase, seconds, stages}, with stages as in times_report.h.
nlohmann::ordered_json timesOf(const live::LiveRecording& recording);
std::string timesText(const live::LiveRecording& recording);  // for a person

// Over the frames in motion: frames per second, latency (median and 95th percentile), how many had a fovea,
// and how many were small pictures because the model was not yet fit to be shown.
struct MotionFigures {
    double framesPerSecond = 0.0;
    double latencyMs = 0.0;
    double lateMs = 0.0;
    std::size_t frames = 0;
    std::size_t withFovea = 0;
    std::size_t beforeModel = 0;
};
MotionFigures motionFigures(const live::LiveRecording& recording);
// One line for the user; with advice if the model came too late for any fovea.
std::string textOf(const MotionFigures& figures);

}  // namespace macula::pictures
