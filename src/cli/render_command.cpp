// macula render PATH -o FILE: one picture, without a window.
#include <CLI/App.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "app/elapsed.h"
#include "app/open_device.h"
#include "app/picture/drawn_picture.h"
#include "app/picture/picture_file.h"
#include "app/picture/render_record.h"
#include "app/picture/render_wish.h"
#include "app/segmentation/segments_to_draw.h"
#include "app/state/state_wish.h"
#include "app/study/combined_mask.h"
#include "app/study/found_volumes.h"
#include "app/study/second_curve.h"
#include "app/study/shown_clip.h"
#include "app/study/study_input.h"
#include "base/check.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/json_text.h"
#include "cli/output_options.h"
#include "cli/render_options.h"
#include "cli/report.h"
#include "formats/volume_file.h"

namespace macula::cli {

namespace {

struct ReadStudy {
    app::StudyInput input;
    std::string series;                              // that was meant, as chooseVolume takes it
    std::shared_ptr<const app::FoundVolumes> found;  // the folder, where its segmentations are needed
};

Result<ReadStudy> readStudy(const app::RenderWish& options, bool needsSegments, Progress& progress) {
    ReadStudy study;
    const bool isFolder =
        !options.path.empty() && options.path != "phantom:" && !formats::isVolumeFileName(options.path);
    if (!isFolder && !options.segments.empty())
        return Error{ErrorCode::usage,
                     "Only a folder of DICOM files can have segmentations.",
                     {},
                     "Leave --segments out."};
    if (!isFolder) {
        MACULA_TRY(study.input, app::loadStudy(options.path, options.series, progress, 0, options.how));
        return study;
    }
    MACULA_TRY(dicom::Scan scan, dicom::scanFolder(options.path, progress, options.how));
    MACULA_TRY(study.series, app::seriesWished(options, scan));
    MACULA_TRY(study.input, app::loadStudy(scan, options.path, study.series, progress));
    if (needsSegments) study.found = std::make_shared<const app::FoundVolumes>(std::move(scan));
    return study;
}

// What a view and --segments leave of the volume.
Result<app::SegmentsToDraw> segmentsOf(const ReadStudy& study,
                                       const std::vector<app::SegmentationChoice>& choices,
                                       std::span<const app::SegmentWish> wishes, Progress& progress) {
    if (!study.found) {
        app::SegmentsToDraw none;
        if (!app::in3dOf(choices).empty() || !app::colouredIn3dOf(choices).empty())
            none.notes.emplace_back("The segments of the view are not here; all of the volume is shown.");
        return none;
    }
    MACULA_TRY(const dicom::Choice chosen, app::chooseVolume(study.found->scan(), study.series));
    const auto& volumes = study.found->volumes();
    const auto volume = std::ranges::find(volumes, chosen.stack, &app::FoundVolume::stack);
    MACULA_CHECK(volume != volumes.end());
    return app::segmentsToDraw(*study.found, *volume, choices, wishes, *study.input.volume, progress);
}

Result<std::vector<app::SegmentWish>> segmentWishesOf(const app::RenderWish& options) {
    std::vector<app::SegmentWish> wishes;
    for (const std::string& typed : options.segments) {
        MACULA_TRY(app::SegmentWish wish, app::segmentWishFrom(typed));
        wishes.push_back(std::move(wish));
    }
    return wishes;
}

// Puts both masks into the clip.
Result<void> addMask(Clip& clip, const std::optional<Mask>& mask, const Volume& volume, Progress& progress) {
    std::vector<Mask> masks;
    for (const std::optional<Mask>& each : {clip.mask, mask})
        if (each) masks.push_back(*each);
    MACULA_TRY(clip.mask, app::combinedMask(masks, volume, progress));
    return {};
}

bool needsSegments(const std::vector<app::SegmentWish>& wishes,
                   const std::vector<app::SegmentationChoice>& choices) {
    return !wishes.empty() || !app::in3dOf(choices).empty() || !app::colouredIn3dOf(choices).empty();
}

// A second volume and the colours of segments, and what there is to say of them.
Result<Additions> additionsOf(const app::RenderWish& options, const app::StudyState& state,
                              const std::optional<SegmentTints>& tints, const app::StudyInput& study,
                              const std::function<void(const std::string&)>& tell, Progress& progress) {
    Additions additions;
    additions.tints = tints;
    if (tints) additions.remark = "coloured segments";
    const app::BesideState* beside = state.beside ? &*state.beside : nullptr;
    if (!options.second.isGiven()) {
        if (beside != nullptr && app::isIn3d(*beside))
            tell("The view has a second volume in the picture; give it by --second to draw both.");
        return additions;
    }
    app::SecondWish wish = options.second;
    wish.how = options.how;
    MACULA_TRY(app::SecondToDraw second, app::secondToDraw(wish, study, beside, progress));
    for (const std::string& note : second.notes) tell(note);
    additions.second = std::move(second.second);
    additions.remark = additions.remark.empty() ? second.remark : second.remark + ", " + additions.remark;
    return additions;
}

Result<void> render(const app::RenderWish& options) {
    const auto begin = std::chrono::steady_clock::now();
    // All that can be wrong on the command line first, then the device, then the study: the slowest comes
    // last.
    MACULA_TRY(app::WishedPicture picture, app::wishedPicture(options));
    app::StudyState& state = picture.state;
    app::PictureRequest& request = picture.request;
    MACULA_TRY(const std::vector<app::SegmentWish> segmentWishes, segmentWishesOf(options));
    const std::vector<app::SegmentationChoice> segmentChoices = std::exchange(state.segmentations, {});
    MACULA_TRY(gpu::LastingDevice device, app::openDevice(options.device, printNote));

    Progress progress(terminalProgressBar(), interruptToken());
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY(ReadStudy read, readStudy(options, needsSegments(segmentWishes, segmentChoices), progress));
    app::StudyInput& study = read.input;
    bringTo16Bits(study);
    app::RenderRecord record{.seriesDigest = study.seriesDigest,
                             .lights = picture.lights,
                             .clip = picture.clip,
                             .loadSeconds = app::secondsSince(start)};
    MACULA_TRY(app::StudyPreset preset, app::completeState(state, options.state, study));
    printNotes(study.notes, study.warnings);
    record.notes = study.notes;
    const auto tell = [&](const std::string& note) {
        printNote(note);
        record.notes.push_back(note);
    };
    for (const std::string& note : app::optionsWithoutEffect(options, state.settings.look)) tell(note);
    record.preset = preset.publicName;
    record.presetFitted = preset.function.fitToVolume.has_value();

    MACULA_TRY(app::ShownClip shown, app::shownClip(state, *study.volume, progress));
    for (const std::string& note : shown.notes) tell(note);
    record.tableRemoved = shown.tableRemoved;
    MACULA_TRY(const app::SegmentsToDraw segments, segmentsOf(read, segmentChoices, segmentWishes, progress));
    for (const std::string& note : segments.notes) tell(note);
    MACULA_TRY_VOID(addMask(shown.clip, segments.mask, *study.volume, progress));
    if (shown.clip.mask) record.masked = shown.clip.mask->remark;
    MACULA_TRY(request.scene.additions, additionsOf(options, state, segments.tints, study, tell, progress));
    if (!trace::isProjection(state.settings.look)) record.additions = request.scene.additions.remark;
    request.scene.volume = study.volume;
    request.scene.function = std::move(preset.function);
    request.scene.clip = std::move(shown.clip);
    request.settings = app::settingsToDraw(options, state, *study.volume);
    record.window = request.settings.window;

    app::DrawnPicture drawn;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(drawn, app::drawPicture(on, request, progress));
        return {};
    }));
    record.add(request, drawn);
    for (const app::PictureNote& note : notesOf(drawn, request)) {
        const std::string line = note.action.empty() ? note.sentence : note.sentence + " " + note.action;
        note.isWarning ? printWarning(line) : printNote(line);
    }
    MACULA_TRY_VOID(app::writePicture(options.output, drawn, request.sizePx, metadata(record)));
    if (!options.json.empty()) MACULA_TRY_VOID(printOrWrite(options.json, jsonText(toJson(record))));
    printWritten(options.output, begin);
    if (progress.cancelled() && !drawn.statistics.converged && options.effort.error > 0.0)
        return Error{
            ErrorCode::cancelled, "Stopped; the picture is written as it was then, with noise.", {}, {}};
    return {};
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    auto options = std::make_shared<app::RenderWish>();
    auto* command = app.add_subcommand("render", "Draw a series to a picture");
    addRenderOptions(*command, *options);
    command->callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace macula::cli
