// Quality presets: named points on the curve of time against error. presets/schema/quality.schema.json is the
// reference.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "pipeline/trace/settings.h"

namespace macula::trace {

struct Quality {
    std::string name;   // key, as in `--quality draft`
    std::string title;  // for people
    std::uint32_t samplesPerPixel = 1;
    int bounces = 1;
    Filter filter = Filter::trilinear;
    Denoising denoising = Denoising::off;
};

// Fails with inputNotUsable: the message names the line or the key, the hint says what was expected. `where`
// is the file, for the error.
Result<Quality> qualityFromJson(std::string_view text, const std::string& where);

}  // namespace macula::trace
