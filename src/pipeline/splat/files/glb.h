// Binary glTF 2.0 with the extension KHR_gaussian_splatting (kernel "ellipse"), as Khronos ratified it: one
// primitive of points with the attributes POSITION, COLOR_0 (for programs without the extension) and
//   KHR_gaussian_splatting:ROTATION   unit quaternion x, y, z, w
//   KHR_gaussian_splatting:SCALE      standard deviations, linear
//   KHR_gaussian_splatting:OPACITY    0 to 1
//   KHR_gaussian_splatting:SH_DEGREE_l_COEF_n   with n from 0 to 2 l, as splats.h has them
// in float32.
//
// Axes. Coordinates of the primitive are those of the model, mm relative to its origin. Its node turns them
// by a quarter about x and scales them to metres, because in glTF y is up and assets face z: a patient stands
// upright, faces z, and the patient's left is at +x. A model with unknown axes is turned as from PLY's axes
// (y down, z forward). Both are rotations: nothing is mirrored. Display colours are marked
// "srgb_rec709_display", linear radiance "lin_rec709_display", which other programs show without the tone
// map. Notes (model_notes.h) are in `extras` of the asset.
//
// Losses: an opacity within 3e-8 of 1 comes back as that of kMaxOpacityLogit, and scales are rounded.
#pragma once

#include <cstddef>
#include <cstdint>
#include <ostream>
#include <span>
#include <string_view>

#include "base/result.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::splat {

inline constexpr std::uint64_t kMostGlbBytes = 0xffffffffu;  // the format stores its length in 32 bits

// Returns how many splats were clamped to kMaxLogScale and kMaxOpacityLogit. Fails with inputNotUsable when
// the model is not valid, empty, or larger than such a file may be. The caller checks the stream's state.
Result<std::size_t> writeGlb(std::ostream& stream, const Splats& splats);

// Reads the first primitive with the extension, with attributes of any type that the extension allows, stored
// in the file itself and not compressed. Nodes are ignored: they place a model in somebody's scene. Without
// Macula's notes the model is foreign, and must have display colours. Errors as readModel.
Result<ModelFile> decodeGlb(std::span<const std::byte> bytes, BadSplats bad = BadSplats::refuse);

// Judges a file by its first four bytes.
bool looksLikeGlb(std::string_view begin);

}  // namespace macula::splat
