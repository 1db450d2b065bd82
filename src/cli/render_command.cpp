// macula render PATH -o FILE: one picture, without a window.
#include <CLI/App.hpp>
#include <chrono>
#include <memory>
#include <utility>

#include "base/elapsed.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/render_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "live/device/open_device.h"
#include "pictures/addition_request.h"
#include "pictures/drawn_picture.h"
#include "pictures/picture_file.h"
#include "pictures/render_record.h"
#include "pictures/render_request.h"
#include "pictures/state_request.h"
#include "scene/camera/usual_view.h"
#include "scene/drawing/drawing_of.h"
#include "scene/drawing/shown_clip.h"
#include "study/open/loaded_study.h"

namespace macula::cli {

namespace {

Result<void> render(const pictures::RenderRequest& options) {
    const auto begin = std::chrono::steady_clock::now();
    // All that can be wrong on the command line first, then the device, then the study: the slowest comes
    // last.
    MACULA_TRY(pictures::RequestedPicture picture, pictures::requestedPicture(options));
    scene::StudyState& state = picture.state;
    pictures::PictureRequest& request = picture.request;
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(options.device, printNote));

    Progress progress(terminalProgressBar(), interruptToken());
    const auto start = std::chrono::steady_clock::now();
    const study::StudyPlace place{options.path, options.series, options.state.presentation, options.how};
    MACULA_TRY(study::ReadStudy read,
               study::readStudy(place, picture.additions.needsSegmentations(), progress));
    study::LoadedStudy& study = read.input;
    bringTo16Bits(study);
    pictures::RenderRecord record{.seriesDigest = study.seriesDigest,
                                  .lights = picture.lights,
                                  .clip = picture.clip,
                                  .loadSeconds = secondsSince(start)};
    MACULA_TRY(scene::StudyPreset preset, pictures::completeState(state, options.state, study));
    printNotes(study.notes, study.warnings);
    record.notes = study.notes;
    const auto tell = [&](const Text& note) {
        printNote(note);
        record.notes.push_back(note);
    };
    for (const Text& note : pictures::optionsWithoutEffect(options, state.settings.look, preset.function))
        tell(note);
    record.preset = preset.publicName;
    record.presetFitted = preset.function.fitToVolume.has_value();

    MACULA_TRY(scene::ShownClip shown,
               scene::shownClip(state, *study.volume, progress, pictures::unaskedTable(options.state)));
    for (const Text& note : shown.notes) tell(note);
    if (!request.camera && !request.from) printNote(sentenceOf(scene::usualView(*study.volume)));
    record.tableRemoved = shown.tableRemoved;
    MACULA_TRY(pictures::DrawnAdditions made,
               pictures::makeAdditions(picture.additions, read, state.settings.look, shown.clip, progress));
    printNotes(made.notes, made.warnings);
    record.notes.insert(record.notes.end(), made.notes.begin(), made.notes.end());
    if (shown.clip.mask) record.masked = shown.clip.mask->remark.english();
    request.scene.additions = std::move(made.additions);
    record.additions = scene::remarkOf(request.scene.additions, state.settings.look).english();
    request.scene.volume = study.volume;
    request.scene.function = std::move(preset.function);
    request.scene.clip = std::move(shown.clip);
    request.settings = pictures::settingsToDraw(options, state, *study.volume);
    record.window = request.settings.window;

    pictures::DrawnPicture drawn;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn, pictures::drawPicture(on, request, progress));
        return {};
    }));
    record.add(request, drawn);
    for (const pictures::PictureNote& note : notesOf(drawn, request)) {
        const Text line = Text::joined({note.sentence, note.action}, " ");
        note.isWarning ? printWarning(line) : printNote(line);
    }
    MACULA_TRY_VOID(pictures::writePicture(options.output, drawn, request.sizePx, metadata(record)));
    if (!options.json.empty()) MACULA_TRY_VOID(printOrWrite(options.json, jsonText(toJson(record))));
    printWritten(options.output, begin);
    if (progress.cancelled() && !drawn.statistics.converged && options.effort.error > 0.0)
        return Error{ErrorCode::cancelled,
                     Text("Stopped; the picture is written as it was then, with noise."),
                     {},
                     {}};
    return {};
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    auto options = std::make_shared<pictures::RenderRequest>();
    auto* command = app.add_subcommand("render", "Draw a series to a picture");
    addRenderOptions(*command, *options);
    command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace macula::cli
