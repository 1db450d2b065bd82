// macula hybrid PATH -o FOLDER: the live picture of a camera that moves, frame by frame, without a window.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "base/progress_bar.h"
#include "cli/addition_options.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/name_option.h"
#include "cli/shared/number_range.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "pictures/recorded_study.h"
#include "session/store.h"

namespace macula::cli {

namespace {

// --sessions and --no-session. `sessions` is the folder, nothing where none is to be kept.
void addStoreOptions(CLI::App& command, std::optional<std::filesystem::path>& sessions) {
    sessions = session::defaultFolder();
    auto* folder =
        command
            .add_option_function<std::filesystem::path>(
                "--sessions", [&sessions](const std::filesystem::path& given) { sessions = given; },
                "Where models of earlier runs are, and this one's is kept")
            ->option_text("FOLDER");
    command
        .add_flag_callback(
            "--no-session", [&sessions] { sessions.reset(); }, "Keep nothing, and begin anew")
        ->excludes(folder);
}

struct HybridOptions {
    pictures::RecordingRequest request;
    bool tellsTimes = false;
};

Result<void> record(const HybridOptions& options) {
    const pictures::RecordingRequest& request = options.request;
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const live::LiveRecording recording,
               pictures::recordStudy(request, printNote, printWarning, progress));
    const std::size_t frames = recording.frames.size();
    fmt::print("Wrote {}: {} {} on {}.\n{}\n", request.folder.string(), frames,
               frames == 1 ? "frame" : "frames", recording.device,
               textOf(pictures::motionFigures(recording)));
    if (options.tellsTimes) fmt::print("{}", pictures::timesText(recording));
    return {};
}

}  // namespace

void addHybrid(CLI::App& app, Action& action) {
    auto options = std::make_shared<HybridOptions>();
    pictures::RecordingRequest& o = options->request;
    live::RecordingOptions& r = o.recording;
    auto* command = app.add_subcommand("hybrid", "Record the live picture while a camera moves");
    addStudyAsOfRender(*command, o.path, o.series, o.how);
    command->add_option("-o,--output", o.folder, "Folder to write frames.jsonl and pictures to")->required();
    addSavedView(*command, o.state.savedView);
    command->add_option("--preset", o.state.preset, "As of render");
    command->add_option("--lights", o.lights, "Name from macula presets");
    command->add_option("--clip", o.state.clip, "As of render");
    command->add_flag("--remove-table", o.state.removeTable, "Leave out the table; CT only");
    addAdditions(*command, o.additions);
    command->add_option("--size", o.size, "Picture size in pixels (default: 1280x720)")->option_text("WxH");
    auto* path =
        command->add_option("--path", o.cameraPath, "JSON file: cameras by time, see docs/hybrid-frame.md");
    auto* view =
        command->add_option("--view", o.state.view, "Where the viewer stands first (default: as of render)")
            ->transform(asViewDirection())
            ->option_text(kViewDirectionNames);
    auto* camera =
        command->add_option("--camera", o.state.camera, "Where the viewer stands first: as of render");
    camera->excludes(view);
    command->add_flag("--parallel", o.state.isParallel,
                      "Parallel rays, as of render; in motion splats, without a traced fovea");
    const auto addNumber = [&](const char* name, double& value, double low, const char* help) {
        return command->add_option(name, value, help)->check(between(low, 3600.0))->capture_default_str();
    };
    auto* turn = addNumber("--turn", r.turnS, 0.5, "Seconds for a turn around the patient");
    auto* moving = addNumber("--seconds", r.movingS, 0.0, "How long the camera moves; 0: not at all");
    for (CLI::Option* option : {view, camera, turn, moving}) option->excludes(path);
    addNumber("--learn", r.learningS, 0.0, "Seconds for the model to learn before the camera moves");
    addNumber("--rest", r.restingS, 0.0, "Seconds after it has stopped");
    addNumber("--pictures", r.picturesPerS, 0.0, "PNG files for each second");
    command->add_flag("--times", options->tellsTimes,
                      "Tell where the time of the render thread went, as times.json does");
    addStoreOptions(*command, o.sessions);
    command->add_option("--device", r.device, "Number or part of the name, see macula devices");
    command->callback([options, &action] { action = [options] { return record(*options); }; });
}

}  // namespace macula::cli
