// A second volume that is looked at together with a study: whose it is, how old, and where it lies.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "app/state/beside_state.h"
#include "app/study/found_volumes.h"
#include "app/study/identity.h"
#include "app/study/opened_study.h"
#include "base/volume.h"

namespace macula::app {

// As far as the images tell. Different when ID, name, date of birth or sex is in both and differs. One when
// both are of one study, or all four agree and there is an ID or a name. Else nobody can know, as with files
// without names; what is written where nobody is named (dicom::isPlaceholder) is as if it were empty.
enum class SamePatient { yes, no, unknown };
SamePatient samePatient(const Identity& a, const Identity& b);
// What differs, in words and without values: {"ID", "date of birth"}.
std::vector<std::string> whatDiffers(const Identity& a, const Identity& b);

enum class Age { earlier, sameDay, later, unknown };
// Of the second against the study, by the dates of the studies.
Age ageOf(const Identity& study, const Identity& second);

// Among the volumes of its series, such as the phases of a heart; of what is of no folder, the only one.
struct PlaceInSeries {
    std::size_t place = 0;
    std::size_t count = 1;
};
PlaceInSeries placeInSeries(const OpenedStudy& study);

// "CT, 2020-03-04, series 3, volume 2 of 20": what is written over a pane whatever else is hidden, so it
// holds no word that a person has typed.
std::string plainTag(const OpenedStudy& study);

// Whether both name the same frame of reference, and may be the same patient's. Copies that were made anew
// for a patient's name keep it.
bool shareFrameOfReference(const OpenedStudy& study, const OpenedStudy& second);

// How they are linked before anybody registers: by their frame of reference, or by hand with the middle of
// one on the middle of the other. Phases of one series share a window.
// `pair` is pairDigest of both.
BesideState firstLink(const OpenedStudy& study, const OpenedStudy& second, const std::string& pair);

// A digest of the fingerprints of both: their voxels and their geometry. Images that were exported anew have
// the UIDs of before, and may have other positions.
std::string pairDigest(const std::string& studyFingerprint, const std::string& secondFingerprint);

// Whether the state names this volume: what is registered of one phase says nothing of another. By UIDs and
// attributes, and so a reason to open it, and none to believe where it lies.
bool names(const BesideState& state, const OpenedStudy& second);
// And whether the place in it is of these two volumes (pairDigest).
bool isOf(const BesideState& state, const OpenedStudy& second, const std::string& pair);
// `place` with the look of `before`: window, colours, opacity, preset, and where it is seen.
BesideState withLookOf(BesideState place, const BesideState& before);
// The volume of the folder that the state is of; nothing where there is none, or several and it names none of
// them.
std::optional<std::size_t> volumeOf(const FoundVolumes& found, const BesideState& state);

}  // namespace macula::app
