#include "scene/drawing/shown_clip.h"

#include <utility>

#include "scene/clip/combined_mask.h"
#include "scene/clip/eye_cut.h"
#include "scene/clip/scissor_mask.h"
#include "scene/second/second_curve.h"

namespace macula::scene {

std::optional<Mask> maskOf(const std::shared_ptr<const segment::PatientMask>& found) {
    if (!(found->removedMl > 0.0)) return std::nullopt;
    return Mask{.labels = std::shared_ptr<const LabelMap>(found, &found->map),
                .numbers = {segment::PatientMask::kPatient},
                .remark = Text("table left out")};
}

namespace {

// The only error is `cancelled`.
Result<ShownClip> withoutSureTable(const ClipPreset& preset, const Volume& volume, Progress& progress) {
    ShownClip shown{.clip = clipFor(preset, volume)};
    if (volume.unit() != Unit::hounsfield) return shown;
    Result<segment::PatientMask> found = segment::findPatient(volume, progress);
    if (!found) {
        if (found.error().code == ErrorCode::cancelled) return found.error();
        shown.notes.push_back(Text("A table was not looked for: {}", found.error().message));
        return shown;
    }
    if (!(found->removedMl > 0.0)) return shown;
    if (found->confidence != segment::Confidence::high) {
        shown.notes.push_back(
            Text("What may be a table is shown, as Macula cannot tell it from the patient for sure; "
                 "--remove-table leaves it out."));
        return shown;
    }
    for (const Message& message : found->messages) shown.notes.push_back(message.sentence);
    shown.notes.push_back(Text("--keep-table shows what was left out."));
    shown.clip.mask = maskOf(std::make_shared<const segment::PatientMask>(*std::move(found)));
    shown.tableRemoved = true;
    return shown;
}

}  // namespace

Result<ShownClip> shownClip(const ClipPreset& preset, bool removeTable, const Volume& volume,
                            Progress& progress) {
    ShownClip shown{.clip = clipFor(preset, volume)};
    if (!removeTable) return shown;
    MACULA_TRY(segment::PatientMask patient, segment::findPatient(volume, progress));
    for (const Message& message : patient.messages) shown.notes.push_back(message.sentence);
    shown.clip.mask = maskOf(std::make_shared<const segment::PatientMask>(std::move(patient)));
    shown.tableRemoved = shown.clip.mask.has_value();
    return shown;
}

Result<ShownClip> shownClip(const StudyState& state, const Volume& volume, Progress& progress,
                            UnaskedTable unasked) {
    const ClipPreset preset = state.clip.value_or(ClipPreset{});
    const bool looksForTable = unasked == UnaskedTable::goesWhereSure && !state.leavesTableOut;
    MACULA_TRY(ShownClip shown, looksForTable ? withoutSureTable(preset, volume, progress)
                                              : shownClip(preset, state.leavesTableOut, volume, progress));
    std::vector<Mask> masks;
    if (shown.clip.mask) masks.push_back(*std::move(shown.clip.mask));
    MACULA_TRY(std::optional<Mask> cut, scissorMask({}, state.cuts.scissors, volume, progress));
    if (cut) masks.push_back(*std::move(cut));
    shown.clip = clipFor(state.clip, state.cuts, volume);
    MACULA_TRY(shown.clip.mask, combinedMask(masks, volume, progress));
    if (!in3dOf(state.segmentations).empty())
        shown.notes.push_back(Text("The view keeps or hides segments; here they change nothing."));
    if (!colouredIn3dOf(state.segmentations).empty())
        shown.notes.push_back(Text("The view has segments in colour; here they have none."));
    if (state.secondVolume && isSecondIn3d(*state.secondVolume))
        shown.notes.push_back(Text("The view has a second volume in the picture; here it is left out."));
    return shown;
}

}  // namespace macula::scene
