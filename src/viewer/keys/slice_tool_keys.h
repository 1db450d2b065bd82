// The table of the slice tools and their keys, from which tool bar, slices and help are made.
#pragma once

#include <QCoreApplication>
#include <QKeySequence>
#include <array>

#include "viewer/keys/slice_tool.h"
#include "viewer/theme/drawn_icon.h"

namespace macula::viewer {

struct SliceToolRow {
    SliceTool tool;
    Glyph glyph;
    const char* name;  // the action's object name is "slice-tool-" with this name
    const char* title;
    const char* key;  // a letter that viewer/keys/keys.h does not use, or one of this table with Shift
    const char* does;
};

// The translation context of `title` and `does`.
inline constexpr const char* kSliceToolContext = "SliceTool";

inline constexpr std::array kSliceTools{
    SliceToolRow{SliceTool::crosshair, Glyph::crosshair, "crosshair",
                 QT_TRANSLATE_NOOP("SliceTool", "Cross-hair"), "C",
                 QT_TRANSLATE_NOOP("SliceTool", "All panes go to the point that is clicked or dragged to")},
    SliceToolRow{SliceTool::window, Glyph::window, "window", QT_TRANSLATE_NOOP("SliceTool", "Window"), "W",
                 QT_TRANSLATE_NOOP("SliceTool", "Drag: wider to the right, brighter up")},
    SliceToolRow{SliceTool::zoom, Glyph::zoom, "zoom", QT_TRANSLATE_NOOP("SliceTool", "Zoom"), "Z",
                 QT_TRANSLATE_NOOP("SliceTool", "Drag: closer up, farther down")},
    SliceToolRow{SliceTool::pan, Glyph::pan, "pan", QT_TRANSLATE_NOOP("SliceTool", "Move"), "M",
                 QT_TRANSLATE_NOOP("SliceTool", "Drag the picture sideways")},
    SliceToolRow{SliceTool::distance, Glyph::distance, "distance", QT_TRANSLATE_NOOP("SliceTool", "Distance"),
                 "D", QT_TRANSLATE_NOOP("SliceTool", "Measure from point to point, in mm")},
    SliceToolRow{
        SliceTool::bidirectional, Glyph::bidirectional, "bidirectional",
        QT_TRANSLATE_NOOP("SliceTool", "Lesion"), "Shift+D",
        QT_TRANSLATE_NOOP("SliceTool",
                          "Measure both axes of a lesion, in mm: the long one, then half of the short")},
    SliceToolRow{SliceTool::angle, Glyph::angle, "angle", QT_TRANSLATE_NOOP("SliceTool", "Angle"), "G",
                 QT_TRANSLATE_NOOP("SliceTool", "Measure between two legs, in degrees")},
    SliceToolRow{SliceTool::cobb, Glyph::cobb, "cobb", QT_TRANSLATE_NOOP("SliceTool", "Cobb Angle"),
                 "Shift+G", QT_TRANSLATE_NOOP("SliceTool", "Measure between two lines, in degrees")},
    SliceToolRow{SliceTool::ellipse, Glyph::ellipse, "ellipse", QT_TRANSLATE_NOOP("SliceTool", "Ellipse"),
                 "E", QT_TRANSLATE_NOOP("SliceTool", "Measure area, in mm², and values within it")},
    SliceToolRow{SliceTool::outline, Glyph::outline, "outline", QT_TRANSLATE_NOOP("SliceTool", "Outline"),
                 "Shift+E",
                 QT_TRANSLATE_NOOP("SliceTool",
                                   "Draw around something by hand, or click its corners and double-click the "
                                   "last: its area, and values within it")},
    SliceToolRow{SliceTool::line, Glyph::line, "line", QT_TRANSLATE_NOOP("SliceTool", "Line"), "Shift+Y",
                 QT_TRANSLATE_NOOP("SliceTool",
                                   "Draw along something by hand, or click its points and double-click the "
                                   "last: its length, in mm")},
    SliceToolRow{SliceTool::arrow, Glyph::arrow, "arrow", QT_TRANSLATE_NOOP("SliceTool", "Arrow"), "H",
                 QT_TRANSLATE_NOOP("SliceTool", "Point at something, drag away, and type words")},
    SliceToolRow{
        SliceTool::probe, Glyph::probe, "probe", QT_TRANSLATE_NOOP("SliceTool", "Probe"), "V",
        QT_TRANSLATE_NOOP("SliceTool", "Read the value of the voxel that is pointed at, in its unit")},
    SliceToolRow{SliceTool::segment, Glyph::segment, "segment", QT_TRANSLATE_NOOP("SliceTool", "Segment"),
                 "U",
                 QT_TRANSLATE_NOOP("SliceTool", "Paint, erase or grow the own segment that is selected")},
    SliceToolRow{SliceTool::curve, Glyph::curve, "curve", QT_TRANSLATE_NOOP("SliceTool", "Curve"), "Y",
                 QT_TRANSLATE_NOOP("SliceTool", "Set the points that a curved plane runs through")},
};

inline QString titleOf(const SliceToolRow& row) {
    return QCoreApplication::translate(kSliceToolContext, row.title);
}
inline QString whatItDoes(const SliceToolRow& row) {
    return QCoreApplication::translate(kSliceToolContext, row.does);
}
inline QKeySequence keyOf(const SliceToolRow& row) {
    return QKeySequence(QString::fromLatin1(row.key), QKeySequence::PortableText);
}

}  // namespace macula::viewer
