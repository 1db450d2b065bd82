#include "pictures/addition_wish.h"

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

namespace macula::app {

namespace {

// What a view and the wish leave of the volume, and in which colours.
Result<SegmentsToDraw> segmentsOf(const AdditionChoice& choice, const ReadStudy& study, Progress& progress) {
    if (!choice.needsSegmentations()) return SegmentsToDraw();
    if (!study.found) {
        SegmentsToDraw none;
        none.notes.emplace_back("The segments of the view are not here; all of the volume is shown.");
        return none;
    }
    MACULA_TRY(const dicom::Choice chosen, chooseVolume(study.found->scan(), study.series));
    const auto& volumes = study.found->volumes();
    const auto volume = std::ranges::find(volumes, chosen.stack, &FoundVolume::stack);
    MACULA_CHECK(volume != volumes.end());
    return segmentsToDraw(*study.found, *volume, choice.ofView, choice.segments, *study.input.volume,
                          progress);
}

// Puts both masks into the clip.
Result<void> addMask(Clip& clip, const std::optional<Mask>& mask, const Volume& volume, Progress& progress) {
    std::vector<Mask> masks;
    for (const std::optional<Mask>& each : {clip.mask, mask})
        if (each) masks.push_back(*each);
    MACULA_TRY(clip.mask, combinedMask(masks, volume, progress));
    return {};
}

Result<void> addSecond(const AdditionChoice& choice, const ReadStudy& study, trace::Look look,
                       MadeAdditions& made, Progress& progress) {
    const BesideState* beside = choice.beside ? &*choice.beside : nullptr;
    if (!choice.second.isGiven()) {
        if (beside != nullptr && isIn3d(*beside) && !trace::isProjection(look))
            made.notes.emplace_back(
                "The view has a second volume in the picture; give it by --second to draw both.");
        return {};
    }
    if (trace::isProjection(look)) {
        made.notes.emplace_back("--second does nothing in this look: it is of all but projections.");
        return {};
    }
    SecondWish wish = choice.second;
    wish.how = study.how;
    MACULA_TRY(SecondToDraw second, secondToDraw(wish, study.input, beside, progress));
    std::ranges::move(second.notes, std::back_inserter(made.notes));
    std::ranges::move(second.warnings, std::back_inserter(made.warnings));
    Additions& additions = made.additions;
    additions.second = std::move(second.second);
    additions.remark = additions.remark.empty() ? second.remark : second.remark + ", " + additions.remark;
    return {};
}

}  // namespace

std::vector<std::filesystem::path> filesOf(const AdditionWish& wish) {
    return {wish.second.path, wish.second.preset};
}

bool AdditionChoice::needsSegmentations() const {
    return !segments.empty() || !in3dOf(ofView).empty() || !colouredIn3dOf(ofView).empty();
}

Result<AdditionChoice> additionChoice(const AdditionWish& wish, const std::filesystem::path& study,
                                      StudyState& state) {
    MACULA_TRY_VOID(check(wish.second, wish.secondLinkIsGiven));
    if (formats::isVolumeFileName(study) && isSameFile(wish.second.path, study)) return secondIsTheStudy();
    if (!wish.second.preset.empty()) MACULA_TRY_VOID(presetToDraw(wish.second.preset, false));
    AdditionChoice choice;
    for (const std::string& typed : wish.segments) {
        MACULA_TRY(SegmentWish segment, segmentWishFrom(typed));
        choice.segments.push_back(std::move(segment));
    }
    if (!choice.segments.empty() && !mayHoldSegmentations(study))
        return Error{ErrorCode::usage,
                     "Only a folder of DICOM files can have segmentations.",
                     {},
                     "Leave --segments out."};
    choice.second = wish.second;
    choice.ofView = std::exchange(state.segmentations, {});
    choice.beside = std::exchange(state.beside, std::nullopt);
    return choice;
}

Result<MadeAdditions> makeAdditions(const AdditionChoice& choice, const ReadStudy& study, trace::Look look,
                                    Clip& clip, Progress& progress) {
    MadeAdditions made;
    MACULA_TRY(SegmentsToDraw segments, segmentsOf(choice, study, progress));
    std::ranges::move(segments.notes, std::back_inserter(made.notes));
    MACULA_TRY_VOID(addMask(clip, segments.mask, *study.input.volume, progress));
    made.additions.tints = std::move(segments.tints);
    if (made.additions.tints) {
        made.additions.remark = "coloured segments";
        made.notes.emplace_back(
            trace::isProjection(look)
                ? "Segments have no colours in this look: they have in all but projections."
                : "Segments are coloured: in them colours are no values of the preset.");
    }
    MACULA_TRY_VOID(addSecond(choice, study, look, made, progress));
    return made;
}

}  // namespace macula::app
