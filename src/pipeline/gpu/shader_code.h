// A compiled shader as the build embeds it. See cmake/MaculaShaders.cmake: the build of trace/path.comp
// defines `macula::shaders::trace_path_comp` in the generated header "shaders/<target>.h".
#pragma once

#include <cstdint>
#include <span>

namespace macula::gpu {

// Refers to static data; copy freely.
struct ShaderCode {
    const char* name = "";  // the source file relative to shaders/, "trace/path.comp"
    std::span<const std::uint32_t> words;
};

}  // namespace macula::gpu
