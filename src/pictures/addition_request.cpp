#include "pictures/addition_request.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/check.h"
#include "formats/volume_file.h"
#include "pictures/output_files.h"
#include "scene/choice/study_preset.h"
#include "scene/clip/combined_mask.h"
#include "scene/second/second_curve.h"
#include "study/open/found_volumes.h"

namespace macula::pictures {

namespace {

// The segments that the view and the options hide, and those that they colour.
Result<scene::SegmentsToDraw> segmentsOf(const ResolvedAdditions& choice, const study::ReadStudy& study,
                                         Progress& progress) {
    if (!choice.needsSegmentations()) return scene::SegmentsToDraw();
    scene::SegmentationsThere there;
    for (const std::filesystem::path& file : choice.labelMaps) {
        MACULA_TRY(study::OpenedLabelMap map, study::openLabelMap(file, *study.input.volume, progress));
        there.labelMaps.push_back(std::move(map));
    }
    if (!study.found && there.labelMaps.empty()) {
        scene::SegmentsToDraw none;
        none.notes.push_back(Text("The segments of the view are not here; all of the volume is shown."));
        return none;
    }
    if (study.found) {
        MACULA_TRY(const dicom::ChosenStack chosen, study::chooseVolume(study.found->scan(), study.series));
        const auto& volumes = study.found->volumes();
        const auto volume = std::ranges::find(volumes, chosen.stack, &study::FoundVolume::stack);
        MACULA_CHECK(volume != volumes.end());
        there.found = study.found.get();
        there.volume = &*volume;
    }
    return scene::segmentsToDraw(there, choice.ofView, choice.segments, *study.input.volume, progress);
}

// Combines the mask of the clip with `mask`.
Result<void> addMask(Clip& clip, const std::optional<Mask>& mask, const Volume& volume, Progress& progress) {
    std::vector<Mask> masks;
    for (const std::optional<Mask>& each : {clip.mask, mask})
        if (each) masks.push_back(*each);
    MACULA_TRY(clip.mask, scene::combinedMask(masks, volume, progress));
    return {};
}

Result<void> addSecond(const ResolvedAdditions& choice, const study::ReadStudy& study, trace::Look look,
                       DrawnAdditions& made, Progress& progress) {
    const scene::SecondVolumeState* beside = choice.secondVolume ? &*choice.secondVolume : nullptr;
    if (!choice.second.isGiven()) {
        if (beside != nullptr && scene::isSecondIn3d(*beside) && !trace::isProjection(look))
            made.notes.emplace_back(
                Text("The view has a second volume in the picture; give it by --second to draw both."));
        return {};
    }
    if (trace::isProjection(look)) {
        made.notes.emplace_back(Text("--second does nothing in this look: it is of all but projections."));
        return {};
    }
    scene::SecondVolumeRequest request = choice.second;
    request.how = study.how;
    MACULA_TRY(scene::DrawableSecond second, scene::secondToDraw(request, study.input, beside, progress));
    std::ranges::move(second.notes, std::back_inserter(made.notes));
    std::ranges::move(second.warnings, std::back_inserter(made.warnings));
    Additions& additions = made.additions;
    additions.second = std::move(second.second);
    additions.remark = Text::joined({second.remark, additions.remark}, ", ");
    return {};
}

}  // namespace

std::vector<std::filesystem::path> filesOf(const AdditionRequest& request) {
    std::vector<std::filesystem::path> files{request.second.path, request.second.preset};
    files.insert(files.end(), request.labelMaps.begin(), request.labelMaps.end());
    return files;
}

bool ResolvedAdditions::needsSegmentations() const {
    return !segments.empty() || !scene::in3dOf(ofView).empty() || !scene::colouredIn3dOf(ofView).empty();
}

Result<ResolvedAdditions> resolveAdditions(const AdditionRequest& request, const std::filesystem::path& study,
                                           scene::StudyState& state) {
    MACULA_TRY_VOID(check(request.second, request.secondLinkIsGiven));
    if (formats::isVolumeFileName(study) && isSameFile(request.second.path, study))
        return scene::secondIsTheStudy();
    if (!request.second.preset.empty()) MACULA_TRY_VOID(scene::presetToDraw(request.second.preset, false));
    ResolvedAdditions choice;
    for (const std::string& typed : request.segments) {
        MACULA_TRY(scene::SegmentRequest segment, scene::segmentRequestFrom(typed));
        choice.segments.push_back(std::move(segment));
    }
    choice.labelMaps = request.labelMaps;
    if (!choice.labelMaps.empty() && choice.segments.empty())
        return Error{ErrorCode::usage,
                     Text("Nothing says what to do with the segments of the label map."),
                     {},
                     Text("Add --segments, such as --segments colour:\"Label 1\".")};
    if (!choice.segments.empty() && choice.labelMaps.empty() && !study::mayHoldSegmentations(study))
        return Error{ErrorCode::usage,
                     Text("Only a folder of DICOM files can have segmentations."),
                     {},
                     Text("Leave --segments out, or give a file with segments by --label-map.")};
    choice.second = request.second;
    choice.ofView = std::exchange(state.segmentations, {});
    choice.secondVolume = std::exchange(state.secondVolume, std::nullopt);
    return choice;
}

Result<DrawnAdditions> makeAdditions(const ResolvedAdditions& choice, const study::ReadStudy& study,
                                     trace::Look look, Clip& clip, Progress& progress) {
    DrawnAdditions made;
    MACULA_TRY(scene::SegmentsToDraw segments, segmentsOf(choice, study, progress));
    std::ranges::move(segments.notes, std::back_inserter(made.notes));
    MACULA_TRY_VOID(addMask(clip, segments.mask, *study.input.volume, progress));
    made.additions.tints = std::move(segments.tints);
    if (made.additions.tints) {
        made.additions.remark = Text("coloured segments");
        made.notes.emplace_back(
            trace::isProjection(look)
                ? Text("Segments have no colours in this look: they have in all but projections.")
                : Text("Segments are coloured: in them colours are no values of the preset."));
    }
    MACULA_TRY_VOID(addSecond(choice, study, look, made, progress));
    return made;
}

}  // namespace macula::pictures
