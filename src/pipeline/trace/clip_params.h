// The shapes of a clip as the parameters of a traced picture; shaders/lib/clip.glsl reads them.
#pragma once

#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "shared/trace_params.h"

namespace macula::trace {

// Of a valid clip, into parameters that are 0.
void writeClip(const Clip& clip, const Volume& volume, shared::TraceParams& params);

// Whether there is any shape to clip rays by.
bool isClipped(const shared::TraceParams& params);

}  // namespace macula::trace
