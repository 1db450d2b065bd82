// The identity and the place of a second volume that is shown with a study.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "base/volume.h"
#include "scene/second/second_volume_state.h"
#include "study/open/found_volumes.h"
#include "study/open/opened_study.h"
#include "study/open/same_patient.h"

namespace macula::scene {

// Index among the volumes of its series, such as cardiac phases, and their number; without a folder 0 of 1.
struct PlaceInSeries {
    std::size_t place = 0;
    std::size_t count = 1;
};
PlaceInSeries placeInSeries(const study::OpenedStudy& study);

// "CT, 2020-03-04, series 3, volume 2 of 20": shown over a pane even if other text is hidden, so it contains
// no word that a person typed.
Text plainTag(const study::OpenedStudy& study);

// The link before any registration: by the frame of reference, or by hand with the middles of both volumes
// aligned. Phases of one series share a window. A dose in the study's frame of reference lies over it, with
// isodoses. `pair` is pairDigest of both.
SecondVolumeState firstLink(const study::OpenedStudy& study, const study::OpenedStudy& second,
                            const std::string& pair);

// A digest of both fingerprints, and so of voxels and geometry. Images that are exported again keep their
// UIDs, but may have other positions.
std::string pairDigest(const std::string& studyFingerprint, const std::string& secondFingerprint);

// Whether the state names this volume, by UIDs and attributes. That justifies opening it, not trusting its
// place: a registration of one phase says nothing about another.
bool namesSecond(const SecondVolumeState& state, const study::OpenedStudy& second);
// Whether the state names this volume, and its place was found for this pair of volumes (pairDigest).
bool isPlacedFor(const SecondVolumeState& state, const study::OpenedStudy& second, const std::string& pair);
// `place` with the window, colours, opacity, preset, in3d and view of `before`. SecondVolumePlace::over
// becomes beside if `place` is not linked.
SecondVolumeState withLookOf(SecondVolumeState place, const SecondVolumeState& before);
// Index of the state's volume among `found`. Nothing if it is missing, or the series has several and the
// state names none.
std::optional<std::size_t> volumeOf(const study::FoundVolumes& found, const SecondVolumeState& state);

}  // namespace macula::scene
