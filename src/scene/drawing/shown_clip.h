// What is shown of a study: the clip that was chosen, and without the table where that was asked for.
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

namespace macula::app {

inline constexpr std::string_view kTableLeftOut = "table left out";  // Mask::remark

// Without the table and what else lies beside the patient; nothing where none of that was found. Shares the
// life of what was found: a map may be as large as the volume.
std::optional<Mask> maskOf(const std::shared_ptr<const segment::PatientMask>& found);

struct ShownClip {
    Clip clip;
    bool tableRemoved = false;       // asked for, and something was: where it was not sure, nothing went
    std::vector<std::string> notes;  // about the table, and what a state has that is not drawn
};

// What becomes of a table when nobody said: it is shown, or it is left out where it is sure
// (segment::Confidence::high) that nothing of the patient goes with it.
enum class UnaskedTable { stays, goesWhereSure };

// Fails as segment::findPatient where the table is to be removed. Of a state its cuts are in it too: fails as
// scissorMask and combinedMask.
Result<ShownClip> shownClip(const ClipPreset& preset, bool removeTable, const Volume& volume,
                            Progress& progress);
// Segments of the state are not hidden or coloured, and its second volume is not there; notes say so, but for
// whoever took them out of the state to draw them: app::additionChoice. `unasked` is of a state that does not
// leave the table out; where it is not found out what is table, a note says so, and all is shown.
Result<ShownClip> shownClip(const StudyState& state, const Volume& volume, Progress& progress,
                            UnaskedTable unasked = UnaskedTable::stays);

}  // namespace macula::app
