// Grayscale Softcopy Presentation States (PS3.3 C.11) on images that are shown as they are.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/text.h"
#include "dicom/presentation/softcopy_state.h"
#include "study/planar/planar_display.h"
#include "study/planar/planar_images.h"

namespace macula::study {

// Of the folder, that names an image of a series. Texts are for the screen only.
struct ListedPresentation {
    std::filesystem::path file;
    std::string label;
    std::string description;
    std::string creator;  // as nameForPeople
    std::string date;     // as dateForPeople
};
// Newest first. Those of another patient are left out.
std::vector<ListedPresentation> presentationsOf(const FoundVolumes& found, const PlanarSeries& series);

// The images without a volume that the object shows, of those of its patient the ones with most of its
// frames; null: none, or it is of another kind. `patient` is Study::patient of the study of the object.
const dicom::Stack* presentedImages(const dicom::OtherObject& object, int patient, const FoundVolumes& found);

// One frame as the object says.
struct PresentedImage {
    PlanarDisplay display;
    int quarters = 0;  // turned clockwise, and then perhaps mirrored
    bool isMirrored = false;
    std::optional<dicom::DisplayedArea> area;  // nothing: all of the image
    std::optional<dicom::DisplayShutter> shutter;
    std::vector<dicom::OverlayMask> overlays;
    std::vector<dicom::SoftcopyAnnotation> annotations;  // from below to above
    std::vector<Text> notes;                             // sentences: what is not shown, or differently
};

bool isPresented(const dicom::SoftcopyState& said, const dicom::Frame& frame);  // whether it is of that frame

// Nothing where the object is not of that frame. `usual` is shown where the object's window is of other
// values than the image has. The polarity of the object takes the place of the image's (C.11.6); without a
// window, all values that the pixels can hold are shown, as the standard asks (C.11.8).
std::optional<PresentedImage> presentedOn(const dicom::SoftcopyState& said, const dicom::Frame& frame,
                                          const dicom::PlanarHeader& header, const dicom::PlanarFrame& pixels,
                                          const PlanarDisplay& usual);

}  // namespace macula::study
