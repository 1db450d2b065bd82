// The peripheral model: a set of 3D Gaussians (splats), as Kerbl et al. 2023 (3DGS) describe them.
//
// Axes are those of the world, patient LPS in mm, unless the model was made elsewhere and does not say.
// Positions are float32 relative to originMm, so a model keeps its precision however far it is from the
// world's origin.
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

#include "base/frames.h"
#include "base/result.h"

namespace macula::splat {

// The space in which the colours of a model blend: linear radiance, tone mapped afterwards (Macula's models),
// or display colours (models made elsewhere).
enum class ColourSpace { linear, display };

// What the coordinates mean. `unknown`: a model made elsewhere that does not say; it must not be measured or
// laid over anatomy.
enum class Axes { patientLps, unknown };

// How a projected splat is kept from falling between pixels. `adaptive` (Macula's models): widened by 0.3
// px^2 where it is thinner than a pixel, by less where it is thicker, and its opacity lowered in proportion,
// so that it keeps its energy (shaders/lib/splat_projection.glsl). The others occur in models made elsewhere.
// `compensated`: always widened by 0.3 px^2, opacity lowered (3DGS and gsplat with antialiasing). `classic`:
// only widened by 0.3 px^2 (3DGS). `mip`: widened by 0.1 px^2, opacity lowered (Mip-Splatting, Yu et al.
// 2024).
enum class LowPass { adaptive, compensated, classic, mip };
inline constexpr std::array kLowPasses{LowPass::adaptive, LowPass::compensated, LowPass::classic,
                                       LowPass::mip};

inline constexpr int kMaxShDegree = 3;

// The coefficients of each channel besides the constant one: 0, 3, 8, 15.
constexpr std::size_t shCount(int degree) {
    return static_cast<std::size_t>((degree + 1) * (degree + 1) - 1);
}

// Limits beyond which a scale (ln of mm: 2e-9 mm, 5e8 mm) or an opacity (2e-9) makes no visible difference.
// The model may hold larger finite values; drawing clamps to these limits, and so does repair.
inline constexpr float kMaxLogScale = 20.0f;
inline constexpr float kMaxOpacityLogit = 20.0f;

// Structure of arrays: entry i of each array belongs to splat i; `sh` has shCount(shDegree) entries for each
// splat, from i * shCount(shDegree) on.
//
// Colour along the unit direction d = (x, y, z) from the eye to the splat, in the axes of the model, for each
// channel: max(0, 0.5 + 0.28209479 dc + sum of sh[k] Y[k](d)), with the real spherical harmonics
//   degree 1: 0.48860251 * { -y, z, -x }
//   degree 2: { 1.09254843 xy, -1.09254843 yz, 0.31539157 (2zz - xx - yy), -1.09254843 xz,
//               0.54627422 (xx - yy) }
//   degree 3: { -0.59004359 y (3xx - yy), 2.89061144 xyz, -0.45704580 y (4zz - xx - yy),
//               0.37317633 z (2zz - 3xx - 3yy), -0.45704580 x (4zz - xx - yy), 1.44530572 z (xx - yy),
//               -0.59004359 x (xx - 3yy) }
struct Splats {
    glm::dvec3 originMm{0.0};
    Axes axes = Axes::patientLps;
    ColourSpace colourSpace = ColourSpace::linear;
    LowPass lowPass = LowPass::adaptive;
    int shDegree = 0;  // 0 to kMaxShDegree; 0 or 1 in training

    std::vector<glm::vec3> position;  // mm, relative to originMm
    std::vector<glm::vec3> logScale;  // ln of the standard deviation in mm along the splat's own axes
    std::vector<glm::vec4> rotation;  // quaternion, model from splat, in the order w, x, y, z: [0] is w. Of
                                      // any length but 0; normalised on use
    std::vector<float> opacityLogit;  // ln(o / (1 - o))
    std::vector<glm::vec3> dc;        // red, green, blue
    std::vector<glm::vec3> sh;

    std::size_t size() const { return position.size(); }

    // New splats are at the origin, of 1 mm, unrotated, half opaque and grey. To change shDegree, call
    // setShDegree.
    void resize(std::size_t count);

    // Adds splat `i` of a model of the same degree at the end.
    void append(const Splats& from, std::size_t i);

    // Keeps the bands that both degrees have; new ones are 0.
    void setShDegree(int degree);

    // Fails with inputNotUsable when the arrays differ in size, the degree or the origin makes no sense, or
    // any splat is bad: it has a number that is not finite, or a quaternion whose squared length is 0 or
    // overflows. The error says how many are bad. A model without splats is valid.
    Result<void> validate() const;
};

// What repair did.
struct Repair {
    std::size_t dropped = 0;  // splats removed
    std::size_t clamped = 0;  // splats changed, and kept
};

// Makes a model valid. Clamps log scales below -kMaxLogScale, and logits to +-kMaxOpacityLogit, infinite ones
// too (a flat splat has the log scale -inf, an opaque one the logit +inf). Removes bad splats, and those that
// would flood every picture: their log scale is above kMaxLogScale or +inf, or their standard deviation is
// above ten times the extent of the model and above ten times the median deviation. The other splats keep
// their order, and their values to the bit. Fails where validate would for the model as a whole.
Result<Repair> repair(Splats& splats);

// The box of the splats' centres, in mm of the world (originMm added). Empty, low > high, for no splats. The
// model must be valid.
Box boundingBox(const Splats& splats);

}  // namespace macula::splat
