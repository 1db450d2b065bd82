#include "viewer/planar/planar_displays.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "viewer/planar/planar_texts.h"

namespace macula::viewer {

namespace {

constexpr double kDoublingPart = 0.25;  // of the pane's width, by which a drag doubles the window
constexpr double kLeastWidth = 1e-6;
constexpr double kMostWidth = 1e9;

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PlanarDisplays)
};

}  // namespace

std::vector<NamedDisplay> displaysOf(const dicom::Frame& frame, const dicom::PlanarHeader& header,
                                     const dicom::PlanarFrame& pixels, const study::PlanarDisplay& now) {
    std::vector<NamedDisplay> all;
    if (pixels.isColour()) return all;
    study::PlanarDisplay each{.window = now.window, .table = {}, .isInverted = now.isInverted};
    for (std::size_t i = 0; i < header.tables.size(); ++i) {
        each.table = i;
        all.push_back({displayText(header, each, false), each});
    }
    each.table.reset();
    for (const DisplayWindow& window : frame.windows) {
        each.window = window;
        const QString name = QString::fromStdString(window.explanation).simplified();
        all.push_back({name.isEmpty() ? displayText(header, each, false) : name, each});
    }
    each.window = study::wholeRange(pixels);
    all.push_back({Words::tr("All values"), each});
    return all;
}

study::PlanarDisplay draggedBy(double partX, double partY, const study::PlanarDisplay& display,
                               const dicom::PlanarHeader& header, const dicom::PlanarFrame& pixels) {
    study::PlanarDisplay dragged = display;
    if (dragged.table || dragged.presented) {
        dragged.table.reset();
        dragged.presented.reset();
        dragged.window = study::wholeRange(pixels);
    }
    DisplayWindow& window = dragged.window;
    window.explanation.clear();
    const bool isLowBright = header.isLowBright != display.isInverted;
    window.center += window.width * (isLowBright ? -partY : partY);
    window.width = std::clamp(window.width * std::exp2(partX / kDoublingPart), kLeastWidth, kMostWidth);
    return dragged;
}

}  // namespace macula::viewer
