// The table of the window's keys and mouse actions: viewport, menus and help are made from it, and a test
// compares docs/window.md with it.
#pragma once

#include <QKeySequence>
#include <QString>
#include <array>
#include <optional>
#include <vector>

#include "base/frames.h"
#include "pipeline/trace/look.h"
#include "scene/state/study_state.h"

class QKeyEvent;
class QAction;
class QMainWindow;
class QToolBar;

namespace macula::viewer {

enum class KeyAction {
    orbit,
    pan,
    zoom,
    roll,
    fly,
    window,
    transfer,
    pick,
    anterior,
    posterior,
    left,
    right,
    superior,
    inferior,
    fit,
    parallel,
    names,
    marks,
    cubeSide,
    look,
    shade,
    resetWindow,
    removeTable,
    noClip,
    clipHandles,
    lights,
    scissors,
    clipFromEye,
    openFolder,
    openFile,
    openArchive,
    openSecond,
    flip,
    openView,
    saveView,
    savePicture,
    saveMeasurements,
    savePresentation,
    undo,
    redo,
    panes,
    panels,
    segmentations,
    measurementList,
    find,
    nextKeyImage,
    sliceStep,
    sliceWindow,
    sliceZoom,
    sliceFit,
    focus,
    sliceTool,
    turnPlanes,
    straightPlanes,
    curve,
    sliceInvert,
    typedWindow,
    copySlice,
    cine,
    removeMeasurement,
    paneAlone,
    settings,
    quality,
    convergeNow,
    sliceMenu,
    ownWindow,
    label,
    imageStep,
    imageWindow,
    imageChange,
    imageMeasure,
    imageBoxes,
    images,
    quit,
    help,  // the last: a test counts to it
};

struct KeyRow {
    KeyAction action;
    const char* hand;      // the mouse action, or several keys, in words
    const char* sequence;  // the key, as QKeySequence reads it; empty: see `hand`
    const char* does;
};
inline constexpr std::array kKeys{
    KeyRow{KeyAction::orbit, "Left drag, arrows", "", "Walk around the patient"},
    KeyRow{KeyAction::pan, "Middle drag, Shift + left drag, Shift + arrows", "", "Move sideways"},
    KeyRow{KeyAction::zoom, "Wheel, right drag, Ctrl + left drag, + and -", "", "Closer, farther"},
    KeyRow{KeyAction::roll, "Alt + left drag, Ctrl + Left and Right, [ and ]", "",
           "Turn the picture: clockwise to the right"},
    KeyRow{KeyAction::fly, "Alt + wheel", "", "Fly in: the camera and what it turns around go forward"},
    KeyRow{KeyAction::window, "Right drag in maximum, minimum, average", "",
           "Window: wider to the right, brighter up"},
    KeyRow{KeyAction::transfer, "Alt + right drag, or drag with T held", "",
           "Transfer function: shift to the right, widen upwards"},
    KeyRow{KeyAction::pick, "Double click in 3D", "", "Turn around what is there, and show it on slices"},
    KeyRow{KeyAction::resetWindow, "", "Ctrl+R", "Window of the series again"},
    KeyRow{KeyAction::anterior, "", "A", "Look from anterior"},
    KeyRow{KeyAction::posterior, "", "P", "Look from posterior"},
    KeyRow{KeyAction::left, "", "L", "Look from the patient's left"},
    KeyRow{KeyAction::right, "", "R", "Look from the patient's right"},
    KeyRow{KeyAction::superior, "", "S", "Look from superior"},
    KeyRow{KeyAction::inferior, "", "I", "Look from inferior"},
    KeyRow{KeyAction::fit, "", "F", "Fit what is visible"},
    KeyRow{KeyAction::parallel, "", "O", "Parallel rays, or seen by an eye"},
    KeyRow{KeyAction::names, "", "N",
           "Patient, study and series over the picture, in title and lists, or not"},
    KeyRow{KeyAction::marks, "", "B", "Cube and scale, or not"},
    KeyRow{KeyAction::cubeSide, "Click on a side of the cube", "", "Look from there, as near as before"},
    KeyRow{KeyAction::look, "Ctrl+1 to Ctrl+6", "", "Cinematic, clear, ray cast, maximum, minimum, average"},
    KeyRow{KeyAction::shade, "", "Ctrl+0", "Shade the ray cast, or not"},
    KeyRow{KeyAction::removeTable, "", "Ctrl+T", "Remove the table of a CT, or show it again"},
    KeyRow{KeyAction::noClip, "", "Ctrl+U", "No clip"},
    KeyRow{KeyAction::clipHandles, "", "K", "Handles of the clip in all pictures, or not"},
    KeyRow{KeyAction::clipFromEye, "Shift + wheel in 3D with handles", "",
           "Cut across the line of sight: deeper, less deep"},
    KeyRow{KeyAction::lights, "Drag a handle, Shift + wheel in 3D with the panel of lights", "",
           "Where a light shines from, how strong it is"},
    KeyRow{KeyAction::scissors, "", "X",
           "Scissors: draw around what is to go in 3D; with Shift, what stays; or not"},
    KeyRow{KeyAction::openFolder, "Drop a folder or a file", "Ctrl+O", "Open a study"},
    KeyRow{KeyAction::openFile, "", "Ctrl+Shift+O", "Open an image or a volume file"},
    KeyRow{KeyAction::openArchive, "", "Ctrl+Shift+A", "Search an archive (PACS), and open a study from it"},
    KeyRow{KeyAction::openSecond, "", "Ctrl+B", "Open a prior or another volume beside the study"},
    KeyRow{KeyAction::flip, "Ctrl+Tab", "J", "The second volume in the place of the study, and back"},
    KeyRow{KeyAction::saveView, "", "Ctrl+S", "Save the view: all that was chosen, and the camera"},
    KeyRow{KeyAction::openView, "", "Ctrl+Shift+V", "Open a view that was saved"},
    KeyRow{KeyAction::savePicture, "", "Ctrl+E", "Save the picture, at any size"},
    KeyRow{KeyAction::saveMeasurements, "", "Ctrl+Shift+E", "Save the measurements as a table"},
    KeyRow{KeyAction::savePresentation, "", "Ctrl+Shift+P", "Save the 3D view as a DICOM presentation state"},
    KeyRow{KeyAction::undo, "", "Ctrl+Z", "Undo the last change"},
    KeyRow{KeyAction::redo, "", "Ctrl+Shift+Z", "Do it again"},
    KeyRow{KeyAction::panes, "F5 to F9", "", "Four panes, or 3D, axial, coronal, sagittal alone"},
    KeyRow{KeyAction::panels, "F2 to F4, F10, F12", "",
           "Panels: studies, transfer function, clip; presets; lights"},
    KeyRow{KeyAction::segmentations, "", "F11", "Panel: segmentations"},
    KeyRow{KeyAction::measurementList, "", "Ctrl+Shift+M", "Panel: measurements"},
    KeyRow{KeyAction::find, "", "Ctrl+F", "Find a study of the folder"},
    KeyRow{KeyAction::nextKeyImage, "", "Ctrl+Shift+K", "Next key image of the folder"},
    KeyRow{KeyAction::sliceStep, "Wheel, Up, Down on slices", "",
           "Next slice; with Shift, or Page Up and Page Down, five; Home and End: to the ends"},
    KeyRow{KeyAction::sliceWindow, "Right drag, 1 to 9 on slices", "",
           "Window: wider to the right, brighter up; or a customary one"},
    KeyRow{KeyAction::sliceZoom, "Ctrl + wheel, middle drag, +, - on slices", "", "Closer, sideways"},
    KeyRow{KeyAction::sliceFit, "F, double right click on slices", "",
           "The whole slice, in the middle of its pane"},
    KeyRow{KeyAction::focus, "Tab, Shift + Tab", "", "To the next pane or control, or back"},
    KeyRow{KeyAction::sliceTool, "C, W, Z, M, D, Shift+D, G, Shift+G, E, Shift+E, Shift+Y, H, V, U, Y", "",
           "Left button on slices: cross-hair, window, zoom, move, distance, lesion, angle, Cobb angle, "
           "ellipse, outline, line, arrow, probe, segment, curve"},
    KeyRow{KeyAction::turnPlanes, "Drag a ring on the cross-hair, Ctrl + Left and Right on slices", "",
           "Turn the planes about the cross-hair; with Shift, in steps of 15 degrees"},
    KeyRow{KeyAction::straightPlanes, "", "Ctrl+Shift+R", "Planes that were turned are straight again"},
    KeyRow{KeyAction::curve, "", "Ctrl+Shift+U", "Panel: curved plane along the points of the curve tool"},
    KeyRow{KeyAction::sliceInvert, "I on slices", "", "White and black change places"},
    KeyRow{KeyAction::typedWindow, "", "Ctrl+Shift+W", "Type the width and the level of the window"},
    KeyRow{KeyAction::copySlice, "Ctrl+C on slices", "", "Copy the pane as a picture, with its measurements"},
    KeyRow{KeyAction::cine, "Space on slices", "", "Play through all slices, or stop"},
    KeyRow{KeyAction::removeMeasurement, "Delete on slices", "", "Remove the measurement that is chosen"},
    KeyRow{KeyAction::paneAlone, "Double click on slices", "", "This pane alone, or all four"},
    KeyRow{KeyAction::settings, "", "Ctrl+,", "Settings: language, look, keys, what is kept"},
    KeyRow{KeyAction::quality, "Ctrl+[ and Ctrl+]", "", "Frames in motion: faster, or more accurate"},
    KeyRow{KeyAction::convergeNow, "", "Ctrl+Return",
           "Trace the picture at rest until it is final; Esc stops"},
    KeyRow{KeyAction::sliceMenu, "Right click, Menu on slices", "", "Windows, and those of your own"},
    KeyRow{KeyAction::ownWindow, "Alt+1 to Alt+9 on slices", "", "A window of your own"},
    KeyRow{KeyAction::label, "Double click on a measurement, Enter", "", "Its label"},
    KeyRow{KeyAction::imageStep, "Wheel, arrows, Space on images", "",
           "Next image or frame; play the loop, or stop; Home and End: to the ends"},
    KeyRow{KeyAction::imageWindow, "Drag on images", "", "Window: wider to the right, brighter up"},
    KeyRow{KeyAction::imageChange, "I, R, M, F, Esc on images", "",
           "Invert, turn clockwise, mirror, fit; back to the volume"},
    KeyRow{KeyAction::imageMeasure, "D, G, E, C, W, O, Delete, Enter on images", "",
           "Measure: distance, angle, ellipse, Cobb angle; window; overlays; remove, label"},
    KeyRow{KeyAction::imageBoxes, "B, L on images", "",
           "The chosen box alone, or all of them; boxes scroll together, or not"},
    KeyRow{KeyAction::images, "", "Ctrl+Shift+I",
           "The slices as they were acquired, in boxes, with priors beside them"},
    KeyRow{KeyAction::help, "", "F1", "All keys"},
    KeyRow{KeyAction::quit, "", "Ctrl+Q", "Quit"},
};

struct LayoutRow {
    scene::Layout layout;
    const char* title;
    const char* sequence;
};
inline constexpr std::array kLayouts{LayoutRow{scene::Layout::fourPanes, "&Four Panes", "F5"},
                                     LayoutRow{scene::Layout::volume, "&3D Alone", "F6"},
                                     LayoutRow{scene::Layout::axial, "A&xial Alone", "F7"},
                                     LayoutRow{scene::Layout::coronal, "C&oronal Alone", "F8"},
                                     LayoutRow{scene::Layout::sagittal, "Sa&gittal Alone", "F9"}};

// The keys of the panels: studies, transfer function, clip, presets, lights.
inline constexpr std::array kPanelKeys{"F2", "F3", "F4", "F10", "F12"};

// Empty for an action without a single key.
QKeySequence keyOf(KeyAction action);
// "Ctrl+1" and so on, in the order of trace::kLooks.
QKeySequence keyOf(trace::Look look);
QKeySequence keyOf(const LayoutRow& row);
// All keys of the action, also of rows that name several in words.
std::vector<QKeySequence> keysOf(KeyAction action);
// The input as a help text has it: "Drop a folder or a file, Ctrl+O".
QString pressedFor(const KeyRow& row);
// The same with the person's own keys, in the language of the window.
QString chosenFor(const KeyRow& row);
// The action of a key that acts on the picture only. Ignores modifiers.
std::optional<KeyAction> actionOf(const QKeyEvent& event);
std::optional<ViewDirection> viewDirectionOf(KeyAction action);

// The enabled action of the window with these keys; null: none. Actions of `tools` count only while that is
// visible. Keys pressed in the native window do not pass through the widgets' shortcuts on every platform.
QAction* actionFor(const QKeyEvent& keys, const QMainWindow& window, const QToolBar& tools);

// The letters of the slice tools are shortcuts of the window, but a list jumps to the entry that begins with
// a letter. Returns whether a list has the focus and should get this key.
bool isForList(const QKeyEvent& key);

}  // namespace macula::viewer
