// SPZ, Niantic's packed splats (github.com/nianticlabs/spz, README; MIT): the form for transport. A header of
// 16 bytes (magic "NGSP", version, number of splats, degree, fractional bits of positions, flags, a reserved
// byte; little endian), then by attribute: positions, opacities, colours, scales, rotations, spherical
// harmonics (per splat coefficient by coefficient, red, green, blue). Up to version 3 the whole file is one
// gzip stream; from version 4 on each attribute is a zstd stream (spz_container.h).
//
// Axes. In the file they are x right, y up, z back (RUB). The model's x, y, z become x, -y, -z in the file,
// and the same turn brings them back: a half turn about x, so left stays left and nothing is mirrored;
// rotations and spherical harmonics turn as well. It is the turn from PLY's axes (x right, y down, z
// forward), so a model has the same coordinates in memory whichever format it came in. A patient is x left, y
// anterior, z inferior in the file. A vendor's record may say that a file has other axes, even left-handed
// ones: Macula then converts them (spz_records.h). Units are those of the model, mm in Macula's files.
// Origin, axes and colour space (model_notes.h) are in the comment of the gzip header, or in a record of the
// container: other programs skip both.
//
// Macula writes version 4, or 3 on request: their rotations are off by 0.005 rad at most, those of version 2
// by 0.2 rad where w is near 0, which shows in needles.
//
// Largest errors: position 2^-(b + 1) mm in each axis, with as many fractional bits b <= 20 as the farthest
// splat leaves (0.00002 mm within 256 mm of the origin); a factor of exp(1/32) in scale; 1/510 in opacity;
// 0.0037 in colour; 1/256 in a coefficient of higher degree. Linear colours are first encoded as sRGB and
// their higher coefficients scaled by its slope, because 8 linear bits would show steps in the dark; other
// programs then show about the right colours.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::splat {

struct SpzBytes {
    std::vector<std::byte> bytes;
    std::size_t clamped = 0;  // splats with a scale, colour or coefficient beyond the range of 8 bits
};

enum class SpzVersion { gzip = 3, zstd = 4 };

// Takes 20 bytes a splat of degree 0, 29 of degree 1, before compression. Fails with inputNotUsable when the
// model is not valid, is empty, has more than 10 million splats (other readers stop there), has a splat more
// than 8 km from its origin, or compresses so well that decodeSpz would take it for a decompression bomb.
Result<SpzBytes> encodeSpz(const Splats& splats, SpzVersion version = SpzVersion::zstd);

// Reads versions 1 to 4, degrees 0 to 3; refuses degree 4. Without Macula's notes the model is foreign: axes
// unknown, display colours, low-pass by the file's flag for antialiasing. Errors as readModel; never unpacks
// more than the header says, and at most 32 times the file's size, or 32 MiB.
Result<ModelFile> decodeSpz(std::span<const std::byte> bytes, BadSplats bad = BadSplats::refuse);

// Whether a file is SPZ by its first four bytes: gzip, or version 4.
bool looksLikeSpz(std::string_view begin);

}  // namespace macula::splat
