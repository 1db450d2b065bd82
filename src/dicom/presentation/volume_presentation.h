// How a volume is rendered in 3D, in the terms of a Volume Rendering Volumetric Presentation State (PS3.3
// A.80.2, modules C.11.22 to C.11.32): a plain value, without pixels and without a patient. Patient LPS, mm.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/frames.h"
#include "base/volume.h"
#include "dicom/write/referenced_series.h"

namespace macula::dicom {

// Maps values to colour and opacity. Entry i of n belongs to the value low + i / (n - 1) * (high - low);
// values beyond get the first or last entry. 0 is none, 65535 full.
struct Palette {
    ValueRange values;  // after Modality LUT or rescale
    // Tables of one length, 2 to 65536. Without red, green and blue: from black to white.
    std::vector<std::uint16_t> red;
    std::vector<std::uint16_t> green;
    std::vector<std::uint16_t> blue;
    std::vector<std::uint16_t> alpha;  // none: from clear to opaque

    bool operator==(const Palette&) const = default;
};

// Keeps the points with dot(outward, p) <= offsetMm; a unit vector.
struct CroppingPlane {
    glm::dvec3 outward{1.0, 0.0, 0.0};
    double offsetMm = 0.0;

    bool operator==(const CroppingPlane&) const = default;
};

// Shows what all of these leave.
struct Cropping {
    // By two opposite corners, along the axes of the volume's voxels, not necessarily the patient's.
    std::vector<Box> boxes;
    std::vector<CroppingPlane> planes;

    bool isNothing() const { return boxes.empty() && planes.empty(); }
    bool operator==(const Cropping& b) const;
};

enum class Projection { perspective, orthographic };

// The visible part: x to the right and y up, in perspective at the distance `farMm` in front of the eye.
struct FieldOfView {
    double leftMm = -1.0;
    double rightMm = 1.0;
    double topMm = 1.0;
    double bottomMm = -1.0;
    double nearMm = 1.0;
    double farMm = 2.0;

    bool operator==(const FieldOfView&) const = default;
};

struct PresentedView {
    Projection projection = Projection::perspective;
    glm::dvec3 positionMm{0.0, -1000.0, 0.0};
    glm::dvec3 lookAtMm{0.0};
    glm::dvec3 up{0.0, 0.0, 1.0};
    FieldOfView field;

    bool operator==(const PresentedView&) const = default;
};

// Phong shading, each factor 0 to 1.
struct PresentedShading {
    bool isDoubleSided = true;
    double ambient = 0.0;
    double diffuse = 0.0;
    double specular = 0.0;
    std::optional<double> shininess;
    glm::dvec3 lightDirection{0.0, 1.0, 0.0};  // the direction in which light travels; a unit vector

    bool operator==(const PresentedShading&) const = default;
};

enum class RenderingMethod { volumeRendered, maximum, minimum };

struct VolumePresentation {
    std::string label = "VOLUME";  // at most 16 of A to Z, 0 to 9, blank and underscore
    std::string description;       // at most 64 characters; may contain a name
    std::string creationDate;      // YYYYMMDD; if it is empty, the writer takes the present
    std::string creationTime;      // HHMMSS
    PresentedSeries series;
    RenderingMethod method = RenderingMethod::volumeRendered;
    Palette palette;
    // The thickness to which opacities refer; nothing if unknown.
    std::optional<double> samplingStepMm;
    Cropping cropping;
    PresentedView view;
    std::optional<PresentedShading> shading;  // nothing: unshaded
    // A view in Macula's own format, in ASCII, which holds more than all of the above. Read only if these are
    // unchanged.
    std::string ownState;

    bool operator==(const VolumePresentation&) const = default;
};

// SHA-256 of all that affects the picture, without labels, date and own state.
std::string digestOf(const VolumePresentation& presentation);

}  // namespace macula::dicom
