// The graphics and texts of a softcopy presentation state (PS3.3 C.10.5, Graphic Annotation; C.10.7, Graphic
// Layer).
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "dicom/read/dataset.h"
#include "dicom/read/referenced_frames.h"

namespace macula::dicom {

// `pixel`: in pixels of the image, from the outer corner of the first one, whose other corner is (1, 1).
// `display`: in parts of the displayed area, from its upper left corner on the screen, after rotation and
// flip.
enum class GraphicUnits { pixel, display };

// Points are (column, row), or (right, down). A circle has its centre and a point on it, an ellipse the ends
// of its major and then of its minor axis; the others have any number.
struct SoftcopyGraphic {
    enum class Kind { point, polyline, interpolated, circle, ellipse };
    Kind kind = Kind::polyline;
    GraphicUnits units = GraphicUnits::pixel;
    std::vector<glm::dvec2> points;
    bool isFilled = false;
};

// Has a box, an anchor, or both.
struct SoftcopyText {
    enum class Justification { left, right, centre };
    struct Box {
        glm::dvec2 topLeft{0.0};
        glm::dvec2 bottomRight{0.0};
        GraphicUnits units = GraphicUnits::pixel;
    };
    struct Anchor {
        glm::dvec2 point{0.0};
        GraphicUnits units = GraphicUnits::pixel;
        bool isVisible = true;
    };
    std::vector<std::string> lines;  // may name a patient
    std::optional<Box> box;
    std::optional<Anchor> anchor;
    Justification justification = Justification::left;
};

struct SoftcopyAnnotation {
    std::vector<ReferencedFrames> images;  // none: all of the object
    std::string layer;
    int order = 0;  // of the layer: greater ones lie above
    std::uint8_t grey = 255;
    std::vector<SoftcopyGraphic> graphics;
    std::vector<SoftcopyText> texts;
};

struct SoftcopyAnnotations {
    std::vector<SoftcopyAnnotation> all;  // from below to above
    bool hasOthers = false;               // graphics of other kinds, or that make no sense, were left out
};

// Bounded in number, and all numbers are finite. Colours of layers become greys as bright as they are.
SoftcopyAnnotations readAnnotations(const Dataset& file);

}  // namespace macula::dicom
