// Reading a picture back to the host.
#pragma once

#include "base/result.h"
#include "pipeline/trace/sampled_picture.h"
#include "pipeline/trace/traced_picture.h"
#include "pipeline/trace/view_reading.h"

namespace macula::trace {

Result<TracedImage> readImage(SampledPicture& picture);      // PathTracer::readback
Result<TracedColours> readColours(SampledPicture& picture);  // PathTracer::readColours

}  // namespace macula::trace
