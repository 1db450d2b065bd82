#include "cli/presentation_export.h"

#include <fmt/format.h>

#include <utility>

#include "base/progress_bar.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/name_option.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "formats/volume_file.h"
#include "pictures/fitted_view.h"
#include "pictures/output_files.h"
#include "scene/drawing/shown_clip.h"
#include "scene/presentation/presentation_file.h"
#include "study/open/scanned_place.h"

namespace macula::cli {

namespace {

// What can be seen, from the side that was asked for: the same fit as of render, for a square picture.
Result<Camera> usualCamera(const PresentationExportRequest& options, const scene::StudyState& state,
                           const Volume& volume, Progress& progress) {
    MACULA_TRY(const scene::ShownClip shown, scene::shownClip(state, volume, progress));
    pictures::FittedView view;
    view.from = options.state.view;
    if (options.state.fovDeg > 0.0) view.verticalFovDeg = options.state.fovDeg;
    view.isParallel = options.state.isParallel;
    return pictures::fittedCamera(pictures::outlineOnHostMm(volume, *state.preset, shown.clip),
                                  state.settings.look, volume, view);
}

Result<void> checkFiles(const PresentationExportRequest& options, const PresentedStudy& study) {
    if (study.path == "phantom:" || formats::isVolumeFileName(study.path))
        return Error{ErrorCode::usage,
                     Text("A presentation state refers to DICOM images, and there are none."),
                     {},
                     Text("Give a folder with DICOM files; macula phantom writes one.")};
    pictures::OutputFiles outputs(study.overwrite);
    outputs.read(study.path);
    for (const std::filesystem::path& input : filesOf(options.state)) outputs.read(input);
    return outputs.write(options.output);
}

}  // namespace

CLI::Option* addPresentation(CLI::App& command, PresentationExportRequest& options) {
    pictures::StateRequest& state = options.state;
    auto* output =
        command
            .add_option(
                "--presentation-state", options.output,
                "Instead of values: DICOM file (.dcm) to write, which says how the series is seen in 3D")
            ->option_text("FILE");
    addSavedView(command, state.savedView);
    command.get_option("--session")->needs(output);
    command.add_option("--preset", state.preset, "Of a presentation state: as of render")->needs(output);
    command.add_option("--clip", state.clip, "As of render")->needs(output);
    auto* view = command.add_option("--view", state.view, "As of render")
                     ->transform(asViewDirection())
                     ->option_text(kViewDirectionNames)
                     ->needs(output);
    command.add_option("--camera", state.camera, "As of render")->needs(output)->excludes(view);
    command
        .add_flag("--deidentify", options.isDeidentified,
                  "Without patient and study, and with other UIDs, by which only who has the series knows it")
        ->needs(output);
    return output;
}

Result<void> exportPresentation(const PresentationExportRequest& options, const PresentedStudy& study) {
    MACULA_TRY_VOID(checkFiles(options, study));
    // A ray cast is what other programs come nearest to; what a view says counts more.
    scene::StudyState usual;
    usual.settings.look = trace::Look::dvr;
    usual.settings.shading = trace::Shading::headlight;
    MACULA_TRY(scene::StudyState state, pictures::stateOf(options.state, std::move(usual)));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const study::ScannedPlace place, study::scanPlace(study.path, progress, study.how));
    MACULA_TRY(const dicom::ChosenStack chosen, study::chooseVolume(place.scan, study.series, study.volume));
    scene::PresentationRequest request;
    MACULA_TRY(request.images, scene::presentedImages(*chosen.series, *chosen.stack));
    MACULA_TRY(study::LoadedStudy input,
               study::loadStudy(place.scan, study.path, study.series, progress, study.volume));
    bringTo16Bits(input);
    MACULA_TRY_VOID(pictures::completeState(state, options.state, input));
    state.seriesDigest = input.seriesDigest;
    if (!state.camera) {
        MACULA_TRY(state.camera, usualCamera(options, state, *input.volume, progress));
    }
    printNotes(input.notes, input.warnings);
    request.state = std::move(state);
    request.volume = input.volume;
    request.isDeidentified = options.isDeidentified;
    MACULA_TRY(const auto leftOut, scene::writePresentation(options.output, request));
    for (const auto& sentence : leftOut) printNote(sentence);
    fmt::print("Wrote a presentation state of {} images\n", request.images.series.images.size());
    return {};
}

}  // namespace macula::cli
