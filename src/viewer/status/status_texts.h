// Texts of the status line about the picture on screen and its peripheral model.
#pragma once

#include <QString>
#include <string>
#include <vector>

#include "base/volume.h"
#include "live/frame/render_events.h"
#include "pipeline/hybrid/model/model_news.h"
#include "pipeline/volume/transfer_function.h"
#include "scene/drawing/drawing.h"
#include "study/open/identity.h"
#include "viewer/overlay/painted_text.h"

namespace macula::viewer {

// The title of a preset, a clip or lights, else its name.
QString titleOr(const std::string& title, const std::string& name);

// Lines that identify patient and study, as linesOf, in the language of the window.
std::vector<std::string> linesToShow(const study::Identity& identity);
// The lines over a 3D picture: `names`, and a note when it shows another series, even if `names` is empty.
LinesOver linesOver(std::vector<std::string> names, const scene::Drawing& drawing);
// Names the picture on screen, how it was made, and its progress.
QString fidelityText(const live::FrameShown& frame);

// The state of the peripheral model; empty if there is none to report. At a first start
// (live::DeviceReady::isFirstStart) the device compiles kernels, and the text says that it takes longer.
QString modelText(const hybrid::ModelNews& model, bool isFirstStart);

// The tool tip of modelText: it says what the model began with, why it takes longer, or why there is none and
// what is shown instead. Often empty.
QString aboutModel(const hybrid::ModelNews& model, bool isFirstStart);

// A warning that the preset was made for another kind of values or images than the volume's. Empty if it
// fits.
QString presetWarning(const TransferFunction& preset, const Volume& volume);

}  // namespace macula::viewer
