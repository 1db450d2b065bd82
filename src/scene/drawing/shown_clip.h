// The part of a study that is shown: its clip, and the table removed on request.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip_json.h"
#include "scene/state/study_state.h"
#include "segment/patient.h"

namespace macula::scene {

inline constexpr std::string_view kTableLeftOut = "table left out";  // Mask::remark in English

// Hides the table and other objects next to the patient; nothing if none were found. Shares ownership of
// `found`, as its map may be as large as the volume.
std::optional<Mask> maskOf(const std::shared_ptr<const segment::PatientMask>& found);

struct ShownClip {
    Clip clip;
    bool tableRemoved = false;  // only if something was removed
    std::vector<Text> notes;    // on the table, and on parts of the state that are not drawn
};

// What happens to a table when the user did not decide: it is shown, or it is removed if segment::Confidence
// is high that it holds nothing of the patient.
enum class UnaskedTable { stays, goesWhereSure };

// Fails as segment::findPatient if the table is to be removed. A state's clip includes its cuts, and can also
// fail as scissorMask and combinedMask.
Result<ShownClip> shownClip(const ClipPreset& preset, bool removeTable, const Volume& volume,
                            Progress& progress);
// Ignores the segments and the second volume of the state, with notes that say so; callers that draw them
// take them out of the state first (pictures::resolveAdditions). `unasked` is for a state that does not leave
// the table out. If the search for a table in HU fails or is not sure, a note says so, and all is shown.
Result<ShownClip> shownClip(const StudyState& state, const Volume& volume, Progress& progress,
                            UnaskedTable unasked = UnaskedTable::stays);

}  // namespace macula::scene
