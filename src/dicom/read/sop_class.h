// The kinds of DICOM objects (PS3.4 B.5) that Macula distinguishes.
#pragma once

#include <string>
#include <string_view>

#include "base/text.h"

namespace macula::dicom {

namespace sop_class {
inline constexpr std::string_view kMediaDirectory = "1.2.840.10008.1.3.10";  // DICOMDIR
inline constexpr std::string_view kCtImage = "1.2.840.10008.5.1.4.1.1.2";
inline constexpr std::string_view kEnhancedCtImage = "1.2.840.10008.5.1.4.1.1.2.1";
inline constexpr std::string_view kLegacyConvertedEnhancedCtImage = "1.2.840.10008.5.1.4.1.1.2.2";
inline constexpr std::string_view kParametricMap = "1.2.840.10008.5.1.4.1.1.30";
// Has Rows, but spectra instead of pixels.
inline constexpr std::string_view kMrSpectroscopy = "1.2.840.10008.5.1.4.1.1.4.2";
inline constexpr std::string_view kSegmentation = "1.2.840.10008.5.1.4.1.1.66.4";
inline constexpr std::string_view kLabelMapSegmentation = "1.2.840.10008.5.1.4.1.1.66.7";
inline constexpr std::string_view kSoftcopyPresentationState =
    "1.2.840.10008.5.1.4.1.1.11.1";                                                 // for grey slices
inline constexpr std::string_view kStructureSet = "1.2.840.10008.5.1.4.1.1.481.3";  // of radiotherapy
inline constexpr std::string_view kVolumePresentationState = "1.2.840.10008.5.1.4.1.1.11.9";  // for a 3D view
}  // namespace sop_class

// Whether the object has pixels, but is not an image of the patient.
bool isSegmentation(std::string_view sopClassUid);

// Any presentation state, for any kind of images.
bool isPresentationState(std::string_view sopClassUid);

// Images of the patient, in slices or otherwise: an object of these without rows and columns has lost them.
bool isImage(std::string_view sopClassUid);

// Projections through the patient, and images from outside: they are not slices, whatever else the header
// says.
bool isProjection(std::string_view sopClassUid);

// The only modality that PS3.3 allows for images of the class; empty where there may be several.
std::string_view modalityOfClass(std::string_view sopClassUid);

// For a person: "Segmentation", "Structured report"; for less common classes "Object of class" with DCMTK's
// name or the UID; "Object of unknown kind" for text that is not a UID.
Text describeSopClass(std::string_view sopClassUid);

}  // namespace macula::dicom
