// A second volume that is looked at together with a study: which it is, and where it lies.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/volume.h"
#include "scene/second/beside_state.h"
#include "study/open/found_volumes.h"
#include "study/open/opened_study.h"
#include "study/open/same_patient.h"

namespace macula::app {

// Among the volumes of its series, such as the phases of a heart; of what is of no folder, the only one.
struct PlaceInSeries {
    std::size_t place = 0;
    std::size_t count = 1;
};
PlaceInSeries placeInSeries(const OpenedStudy& study);

// "CT, 2020-03-04, series 3, volume 2 of 20": what is written over a pane whatever else is hidden, so it
// holds no word that a person has typed.
std::string plainTag(const OpenedStudy& study);

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
