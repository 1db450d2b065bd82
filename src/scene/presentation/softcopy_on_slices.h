// A Grayscale Softcopy Presentation State, applied to slices of a volume.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "dicom/presentation/softcopy_state.h"
#include "dicom/stack/stack.h"
#include "scene/state/study_state.h"
#include "slices/slice_plane.h"
#include "study/open/opened_study.h"

namespace macula::scene {

// The part of a slice to show, scaled to fit the pane.
struct SliceArea {
    slices::Orientation orientation = slices::Orientation::axial;  // of the pane
    glm::dvec3 centreMm{0.0};
    glm::dvec2 sizeMm{1.0};  // to the right and down in the pane

    bool operator==(const SliceArea&) const = default;
};

struct SoftcopyOnSlices {
    SliceState slices;
    std::optional<SliceArea> area;  // nothing: all of the volume
    std::vector<Text> notes;        // sentences: what Macula does not show, or shows differently
};

// Applies the object to its images in the stack. The cross-hair moves to the middle of the displayed area of
// the first image that the object names, in the planes of the acquisition. A window applies only where the
// rescale of the object and of its images gives the volume's values. In a multi-frame file only the frames
// that the object names count; all slices are shown like the first image, and a note says so. Slices are
// never turned or mirrored: an object that asks for that loses its area. Everything else stays as in `usual`.
// Error: inputNotUsable if the stack has none of its images; the error names `where`. `isLowBright` as in
// OpenedStudy.
Result<SoftcopyOnSlices> softcopyOn(const dicom::SoftcopyState& said, const dicom::Stack& stack,
                                    const Volume& volume, bool isLowBright, SliceState usual,
                                    const std::string& where);

// Reads the file and applies it to the open study. Error: usage if the study does not come from a DICOM
// folder.
Result<SoftcopyOnSlices> openSoftcopy(const std::filesystem::path& path, const study::OpenedStudy& study,
                                      SliceState usual);

}  // namespace macula::scene
