// What the status line says of the picture on screen and of its peripheral model.
#pragma once

#include <QString>

#include "pipeline/hybrid/model_news.h"
#include "viewer/render_events.h"

namespace macula::viewer {

// What is on screen, how it was made, and how far it has come.
QString fidelityText(const FrameShown& frame);

// What the peripheral model is doing; empty where there is nothing to say.
QString modelText(const hybrid::ModelNews& model);

// Why there is none, and what is shown instead; empty where there is one, or none is wanted.
QString whyNoModel(const hybrid::ModelNews& model);

}  // namespace macula::viewer
