// What a viewer needs to show an image as it is: an X-ray, an ultrasound loop, a photograph. Values, windows
// and rescaling are those of Frame (stack/instance.h).
#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/text.h"
#include "dicom/planar/colours.h"
#include "dicom/planar/display_shutter.h"
#include "dicom/planar/overlay_planes.h"
#include "dicom/stack/intensity.h"

namespace macula::dicom {

// Of the VOI LUT Sequence (PS3.3 C.11.2.1.1).
struct VoiTable {
    std::shared_ptr<const ModalityLut> table;
    int bits = 8;             // of its entries: the largest is white
    std::string explanation;  // may be empty

    bool operator==(const VoiTable&) const = default;
};
// Those of an image, or of an item of a presentation state. Tables that do not fit their descriptor are left
// out.
std::vector<VoiTable> readVoiTables(const Dataset& header, bool valuesAreSigned);

// The size of a pixel in the plane that is measured (PS3.3 10.7).
struct PixelSize {
    enum class Of {
        object,    // calibrated, or measured where the patient is
        regions,   // of ultrasound: where a region is in millimetres, and nowhere else
        detector,  // of a projection: what lies before the detector is smaller
        estimate,  // at the detector, divided by an estimated magnification
        film,      // of a film that was scanned: no length of the patient
    };
    // How Pixel Spacing of an object was calibrated (0028,0A02); `unsaid` also for all that is no projection.
    enum class Calibration { unsaid, geometry, fiducial };
    Of of = Of::object;
    Calibration calibration = Calibration::unsaid;
    double columnMm = 1.0;  // between columns
    double rowMm = 1.0;     // between rows
    double magnification = 1.0;
};

// A region of an ultrasound image with a scale of its own (PS3.3 C.8.5.5), in pixels, both ends included.
struct UltrasoundRegion {
    enum class Unit {
        none,
        millimetres,  // cm in the file
        seconds,
        hertz,
        centimetresPerSecond,
        percent,
        decibels,
        degrees,
        other,
    };
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
    Unit unitX = Unit::none;
    Unit unitY = Unit::none;
    double perColumn = 0.0;  // in units; a row may count upwards
    double perRow = 0.0;
    bool isLowPriority = false;  // where it meets another region, that one counts

    // Whether a place lies in it; in pixels, from the outer corner of the first one.
    bool holds(double column, double row) const;
};

// How frames follow each other in time (PS3.3 C.7.6.5); frameMs is empty where the file does not say.
struct CineTiming {
    std::vector<double> frameMs;  // how long each frame is shown, all above 0
    bool sweeps = false;          // forwards and backwards: Preferred Playback Sequencing 1
};

struct PlanarHeader {
    bool isOfFrame = false;    // other frames of the file may say something else
    bool isLowBright = false;  // MONOCHROME1, or a presentation LUT that inverts
    std::vector<VoiTable> tables;
    std::shared_ptr<const ColourPalette> palette;  // of PALETTE COLOR
    bool isByPlane = false;                        // of three samples: Planar Configuration 1
    std::vector<UltrasoundRegion> regions;
    // Of all pixels, or (PixelSize::Of::regions) of those in regions in millimetres, if these agree.
    std::optional<PixelSize> pixelSize;
    double pixelHeightOverWidth = 1.0;  // also where no size is known
    CineTiming cine;
    std::optional<DisplayShutter> shutter;
    std::vector<OverlayPlane> overlays;
    // Where rows and columns run to: letters of L, R, A, P, H and F, as "L", "FR"; PS3.3 C.7.6.1.1.1. Both
    // are empty where the file does not say, or has other letters.
    std::array<std::string, 2> towards;
    std::string laterality;    // R, L, B or U
    std::string viewPosition;  // "CC", "AP"; may be empty
    std::string bodyPart;      // "CHEST": Body Part Examined; may be empty
};

// Of frame `frame`, from 0. Fails with inputNotUsable when the file is gone or no image. Never throws but for
// lack of memory.
Result<PlanarHeader> readPlanarHeader(const std::filesystem::path& file, int frame = 0);

}  // namespace macula::dicom
