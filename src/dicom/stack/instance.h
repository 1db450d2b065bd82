// One image file and its frames, as the header describes them. Enhanced multi-frame objects and single-frame
// ones come out the same: each frame has its own plane, values and attributes (PS3.3 C.7.6.16).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/stack/geometry.h"
#include "dicom/stack/intensity.h"
#include "dicom/stack/suv.h"

namespace macula::dicom {

// An optional is empty when the file gives no value, or an invalid one. Paths and UIDs may name a patient:
// never logged.

// The data that all frames of a file share.
struct Instance {
    std::filesystem::path file;
    std::string sopClassUid;
    std::string sopInstanceUid;
    std::string transferSyntaxUid;      // the one that the pixels are in
    std::string contradictedSyntaxUid;  // the one that the file names, if it differs
    std::string photometricInterpretation;
    std::string modality;          // that of the SOP class where the file gives none; may be empty
    bool modalityMissing = false;  // no Modality, which each image must have (type 1, PS3.3 C.7.3.1)
    std::optional<int> instanceNumber;
    std::optional<int> acquisitionNumber;
    // The numbers of images that the file gives for the acquisition, a PET volume, the series and the study.
    std::optional<int> imagesInAcquisition, slicesOfVolume, seriesRelatedInstances, studyRelatedInstances;
    int columns = 0;
    int rows = 0;
    int frames = 1;
    int framesClaimed = 1;  // by NumberOfFrames; more than the file has room for when it is cut off
    int samplesPerPixel = 1;
    std::optional<CellFormat> format;
    bool multiFrame = false;        // NumberOfFrames is present: positions may lie in functional groups
    bool greyscaleAssumed = false;  // PhotometricInterpretation is missing, as in ACR-NEMA files
    bool lossy = false;             // lossily compressed, now or before
    std::uint64_t strayBytes = 0;   // see HeaderFile
    std::uint64_t pixelBytes = 0;   // size of the pixel data, if uncompressed
    double framesBeyond = 0.0;      // frames beyond NumberOfFrames that have pixels or descriptions
    std::uint16_t overlayBits = 0;  // bits of a cell that hold an overlay (retired: PS3.3 2004 C.9.2)
    Suv suv;
    std::string concatenationUid;  // PS3.3 C.7.6.16.2.2.4; empty when the file is not part of one
    int concatenationTotal = 0;    // 0: not said
};

// The attribute that gave the size of a pixel. Only pixelSpacing may be calibrated (PS3.3 10.7).
enum class PixelSpacingSource { none, pixelSpacing, imagerPixelSpacing, nominalScannedPixelSpacing };

struct Frame {
    std::shared_ptr<const Instance> instance;
    int number = 0;  // of the file's frames, from 0

    std::vector<std::string> imageType;  // the frame's own, where frames have one
    std::string frameOfReferenceUid;
    std::optional<glm::dvec3> positionMm;
    std::optional<ImagePlane> plane;  // needs position, orientation and pixel spacing
    bool hasOrientation = false;
    bool orientationContradicted = false;  // the letters of PatientOrientation contradict it
    PixelSpacingSource spacingSource = PixelSpacingSource::none;
    bool isInVolumeFrame = false;      // ultrasound: placed relative to the transducer, not the patient
    bool isPlacedByOrder = false;      // placed by its frame number: see frameOffsets
    bool numbersRepaired = false;      // numbers of its position were malformed, but readable
    std::string_view malformedNumber;  // the keyword of such numbers that cannot be read; empty if all can
    std::optional<double> sliceLocation;
    std::optional<double> sliceThicknessMm;  // above 0; does not affect where slices lie

    std::optional<double> slope;  // RescaleSlope, or that of the real world value mapping
    std::optional<double> intercept;
    bool rescaleInvalid = false;  // present, but not usable: no number, or a slope of 0
    std::string rescaleType;      // also the unit of the real world value mapping, and of the modality LUT
    std::string units;            // Units of PET (0054,1001)
    bool realWorld = false;       // slope and intercept come from a real world value mapping
    std::shared_ptr<const ModalityLut> modalityLut;  // replaces slope and intercept
    bool modalityLutInvalid = false;
    std::optional<RawRange> padding;
    std::optional<ValueRange> floatPadding;
    std::vector<DisplayWindow> windows;
    bool windowInvalid = false;
    bool hasDisplayTable = false;  // VOI LUT Sequence, PS3.3 C.11.2.1.1

    std::vector<std::string> attributes;  // values of the attributes of splitRules()
    // Keywords of elements that affect voxels' values or places and occur twice with different values.
    std::vector<std::string_view> contradicted;
};

// The bits that one frame takes in uncompressed pixel data; 0 when the file does not say.
std::uint64_t bitsPerFrame(const Instance& instance, const Dataset& header);

// The frames of a header that has Rows and Columns; one entry per frame of the file, at least one.
std::vector<Frame> readFrames(const std::filesystem::path& file, const HeaderFile& read);

// The input of intensity.h, with 1 and 0 for a missing slope and intercept, which assess (stack.h) reports.
SliceIntensity sliceIntensity(const Frame& frame);

}  // namespace macula::dicom
