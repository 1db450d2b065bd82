// The PLY files of 3DGS (Kerbl et al. 2023): one element `vertex` with the properties x y z, nx ny nz
// (written as 0, not read), f_dc_0..2, f_rest_0..(3 * shCount - 1) by channel (all of red first), opacity
// (logit), scale_0..2 (ln), rot_0..3 (w, x, y, z). The convention has no unit and no axes: viewers assume x
// right, y down and z forward, right-handed.
//
// Macula writes binary little endian, float32, which holds a model exactly. Coordinates are those of the
// model, patient LPS in mm relative to the origin: right-handed too, so nothing is ever mirrored. A viewer
// that knows nothing of Macula shows the patient from the feet, anterior up, the patient's left on the right
// of the picture, like an axial slice. The rest is in comments, see model_notes.h.
#pragma once

#include <cstdint>
#include <istream>
#include <ostream>

#include "base/result.h"
#include "pipeline/splat/files/model_file.h"

namespace macula::splat {

// Reads from the stream's current position, with `bytes` bytes left. Accepts ascii and binary of both byte
// orders, properties in any order and of any type, and degrees 0 to 3; skips unknown elements and properties.
// Without Macula's comments a model is foreign, and its coordinates are left as they are. Variants of the
// convention that it reads: colours as bytes (red, green, blue: Nerfstudio), splats with two scales (2DGS;
// drawn as flat Gaussians), filter_3D (Mip-Splatting; folded into scale and opacity, and the model's low-pass
// is `mip`), and the packed form of SuperSplat (ply_packed.h). Errors as readModel.
Result<ModelFile> readPly(std::istream& stream, std::uint64_t bytes, BadSplats bad = BadSplats::refuse);

// Fails with inputNotUsable when the model is not valid or empty. The caller checks the stream's state.
Result<void> writePly(std::ostream& stream, const Splats& splats);

}  // namespace macula::splat
