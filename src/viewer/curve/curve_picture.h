// The picture of a curved plane and of a section across it, made on another thread.
#pragma once

#include <QImage>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "slices/colour_table.h"
#include "slices/curved_slice.h"

namespace macula::viewer {

// How a person has the curved plane drawn.
struct CurveLook {
    slices::CurvedKind kind = slices::CurvedKind::straightened;
    double turnDeg = 0.0;
    double heightMm = 60.0;

    bool operator==(const CurveLook&) const = default;
};

struct CurveRequest {
    std::shared_ptr<const Volume> volume;
    std::vector<glm::dvec3> pointsMm;
    CurveLook look;
    slices::Slab slab;
    DisplayWindow window;
    bool isInverted = false;
    bool isLowBright = false;  // the display of the images shows low values white
    double sectionAtMm = 0.0;  // along the curve
    int widthPx = 1;           // device pixels that are there for the curve
    int sectionPx = 1;         // a side of the section
    double pixelRatio = 1.0;
    QString phaseText = {};  // which phase of the study it is; empty: it has none

    bool operator==(const CurveRequest&) const = default;
};

struct CurvePicture {
    CurveRequest of;
    std::shared_ptr<const slices::CurvedFrame> frame;
    QImage curved;
    QImage section;
    slices::SliceFrame sectionFrame;
};

// Needs a usable curve. Errors: cancelled; outOfMemory.
Result<CurvePicture> makeCurvePicture(const CurveRequest& request, const CancelToken& token);

}  // namespace macula::viewer
