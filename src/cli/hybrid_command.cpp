// macula hybrid PATH -o FOLDER: the live picture of a camera that moves, frame by frame, without a window.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <memory>

#include "app/frame/recorded_study.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/name_option.h"
#include "cli/number_range.h"
#include "cli/report.h"
#include "cli/study_options.h"

namespace macula::cli {

namespace {

Result<void> record(const app::RecordingWish& wish) {
    Progress progress(terminalProgressBar(), interruptToken());
    const auto tell = [](const std::string& note, bool changesWhatIsSeen) {
        changesWhatIsSeen ? printWarning(note) : printNote(note);
    };
    MACULA_TRY(const app::LiveRecording recording, app::recordStudy(wish, tell, progress));
    if (recording.isFull) printNote("Pictures left out: there were too many. Lower --pictures or --size.");
    const app::MotionFigures motion = app::motionFigures(recording);
    fmt::print("Wrote {}: {} frames on {}\n", wish.folder.string(), recording.frames.size(),
               recording.device);
    if (motion.frames > 0)
        fmt::print(
            "In motion {:.1f} frames/s, {:.0f} ms from pose to picture (95 % below {:.0f} ms), {} of {} "
            "with a fovea\n",
            motion.framesPerSecond, motion.latencyMs, motion.lateMs, motion.withFovea, motion.frames);
    return {};
}

}  // namespace

void addHybrid(CLI::App& app, Action& action) {
    auto wish = std::make_shared<app::RecordingWish>();
    app::RecordingWish& o = *wish;
    app::RecordingOptions& r = o.recording;
    auto* command = app.add_subcommand("hybrid", "Record the live picture while a camera moves");
    command->add_option("PATH", o.path, "As of render (default: the phantom)");
    command->add_option("-o,--output", o.folder, "Folder to write frames.jsonl and pictures to")->required();
    command->add_option("--series", o.series, "As of render");
    addJoin(*command, o.how);
    command->add_option("--preset", o.preset, "As of render");
    command->add_option("--lights", o.lights, "Name from macula presets");
    command->add_option("--clip", o.clip, "As of render");
    command->add_flag("--remove-table", o.removeTable, "As of render");
    command->add_option("--size", o.size, "Picture size in pixels")
        ->option_text("WxH")
        ->capture_default_str();
    auto* path =
        command->add_option("--path", o.cameraPath, "JSON file: cameras by time, see docs/hybrid-frame.md");
    auto* view = command->add_option("--view", r.from, "Where the viewer stands first (default: anterior)")
                     ->transform(asViewDirection())
                     ->option_text(kViewDirectionNames)
                     ->excludes(path);
    command->add_option("--camera", o.camera, "Where the viewer stands first: as of render")
        ->excludes(path)
        ->excludes(view);
    command->add_option("--turn", r.turnS, "Seconds for a turn around the patient")
        ->check(between(0.5, 3600.0))
        ->excludes(path)
        ->capture_default_str();
    command->add_option("--seconds", r.movingS, "How long the camera moves; 0: not at all")
        ->check(between(0.0, 3600.0))
        ->excludes(path)
        ->capture_default_str();
    command->add_option("--learn", r.learningS, "Seconds for the model to learn before the camera moves")
        ->check(between(0.0, 3600.0))
        ->capture_default_str();
    command->add_option("--rest", r.restingS, "Seconds after it has stopped")
        ->check(between(0.0, 3600.0))
        ->capture_default_str();
    command->add_option("--pictures", r.picturesPerS, "PNG files for each second")
        ->check(between(0.0, 1000.0))
        ->capture_default_str();
    command->add_option("--device", r.device, "Number or part of the name, see macula devices");
    command->callback([wish, &action] { action = [wish] { return record(*wish); }; });
}

}  // namespace macula::cli
