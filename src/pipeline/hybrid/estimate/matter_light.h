// How light reaches the shown part of coarse matter: from the six sides of the volume, as diffuse beams that
// matter weakens cell by cell; and how bright these must be to explain the colours that a model has learnt.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/hybrid/estimate/coarse_matter.h"
#include "pipeline/trace/environment.h"

namespace macula::hybrid {

// The shares, 0 to 1, of the light from -x, +x, -y, +y, -z and +z of the grid that reach a cell.
using SideLight = std::array<float, 6>;

struct LitMatter {
    std::vector<float> extinctionPerMm;  // by cell: the mean over its samples that are shown
    std::vector<float> opacity;          // by cell, of a cube of its volume
    std::vector<SideLight> light;        // by cell

    // The share of the light outside that reaches a cell, averaged over the sides.
    float openness(std::size_t cell) const;
};
// The rise of opacity across a cell, along the axes of the grid: 1 from a transparent to an opaque neighbour.
inline constexpr float kSurfaceRise = 0.1f;  // a smaller rise is not a surface
glm::vec3 riseAround(const CoarseMatter& matter, const LitMatter& lit, std::size_t cell);
// The light that falls on the surface that a cell is part of, found one cell outside it. The cell's own light
// if it is not part of a surface.
SideLight lightOn(const CoarseMatter& matter, const LitMatter& lit, std::size_t cell);
// Uses all cores.
LitMatter litMatter(const CoarseMatter& matter, const ShownMatter& shown);

// The part of diffuse light that a half space of isotropic scatterers of that albedo reflects, by channel:
// the diffusive reflectance of Hapke 1981, "Bidirectional reflectance spectroscopy 1". An albedo of 1
// reflects all.
glm::vec3 reflectanceOf(const glm::vec3& albedo);

// The linear radiance of white matter for a SideLight of 1 from each side; the last is added in any light.
struct LightOfSides {
    std::array<glm::vec3, 7> radiance{};

    glm::vec3 at(const SideLight& light) const;
};

// The light of an environment in the patient's frame on a volume with these axes. A surface is lit from three
// sides: each gives a third.
LightOfSides lightOf(const trace::Environment& environment, const glm::dmat3& worldFromVoxel);

struct LitSample {
    SideLight light;
    glm::vec3 reflectance;
    glm::vec3 radiance;  // linear, of the matter there
    float weight;
};
// The non-negative light that explains the samples' radiance with the least squared error. Sides that the
// samples do not determine stay near `expected`.
LightOfSides fittedLight(std::span<const LitSample> samples, const LightOfSides& expected);

}  // namespace macula::hybrid
