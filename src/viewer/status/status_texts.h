// What the status line says of the picture on screen and of its peripheral model.
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

// Of a preset, a clip or lights.
QString titleOr(const std::string& title, const std::string& name);

// Whose picture it is, in the language of the window: a line each, as linesOf has them.
std::vector<std::string> linesToShow(const app::Identity& identity);
// Of a 3D picture so drawn: `names`, and the remark that something of another series is in it, also where
// nobody is named.
LinesOver linesOver(std::vector<std::string> names, const app::Drawing& drawing);
// What is on screen, how it was made, and how far it has come.
QString fidelityText(const app::FrameShown& frame);

// What the peripheral model is doing; empty where there is nothing to say. At a first start
// (app::DeviceReady::isFirstStart) the device compiles kernels, and the text says that it takes longer.
QString modelText(const hybrid::ModelNews& model, bool isFirstStart);

// The tool tip of modelText: it says what the model began with, why it takes longer, or why there is none and
// what is shown instead. Empty where there is nothing to say.
QString aboutModel(const hybrid::ModelNews& model, bool isFirstStart);

// A preset that was made for another kind of values, or of images, than those of the volume: what its colours
// mean there. Empty where it fits.
QString presetWarning(const TransferFunction& preset, const Volume& volume);

}  // namespace macula::viewer
