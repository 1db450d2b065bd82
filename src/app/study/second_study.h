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

// As far as the images tell. One only when ID, name, date of birth and sex all agree and there is an ID or a
// name; different when one of them is in both and differs. Else nobody can know, as with files without names.
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
BesideState firstLink(const OpenedStudy& study, const OpenedStudy& second);

// Whether the state is of this volume: what is registered of one phase says nothing of another.
bool isOf(const BesideState& state, const OpenedStudy& second);
// The volume of the folder that the state is of; nothing where there is none, or several and it names none of
// them.
std::optional<std::size_t> volumeOf(const FoundVolumes& found, const BesideState& state);

}  // namespace macula::app
