// Names and numbers of the glTF files of splats, which the writer and the reader share (glb.h).
#pragma once

#include <fmt/format.h>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace macula::splat::glb {

inline constexpr std::string_view kMagic = "glTF";
inline constexpr std::uint32_t kVersion = 2;
inline constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
inline constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN"
inline constexpr std::size_t kHeaderBytes = 12;
inline constexpr std::size_t kChunkHeaderBytes = 8;

inline constexpr int kByte = 5120;  // component types, from here to kFloat
inline constexpr int kUnsignedByte = 5121;
inline constexpr int kShort = 5122;
inline constexpr int kUnsignedShort = 5123;
inline constexpr int kFloat = 5126;
inline constexpr int kPoints = 0;  // mode of a primitive

inline constexpr const char* kExtension = "KHR_gaussian_splatting";
inline constexpr const char* kKernel = "ellipse";
inline constexpr const char* kDisplayColours = "srgb_rec709_display";
inline constexpr const char* kLinearColours = "lin_rec709_display";
inline constexpr const char* kNotes = "macula";  // in `extras` of the asset

// "KHR_gaussian_splatting:SCALE".
inline std::string attribute(std::string_view name) {
    return fmt::format("{}:{}", kExtension, name);
}
// The attribute of coefficient `n` of a degree, 0 to 2 * degree.
inline std::string harmonic(int degree, int n) {
    return attribute(fmt::format("SH_DEGREE_{}_COEF_{}", degree, n));
}

}  // namespace macula::splat::glb
