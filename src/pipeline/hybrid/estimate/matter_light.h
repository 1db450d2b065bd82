// From where light comes into what is shown of coarse matter: along the six sides of the volume, as diffuse
// beams that matter weakens cell by cell; and what light that must be, by what a model has learnt.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "pipeline/hybrid/estimate/coarse_matter.h"
#include "pipeline/trace/environment.h"

namespace macula::hybrid {

// The parts of the light from -x, +x, -y, +y, -z and +z of the grid that get to a cell, 0 to 1.
using SideLight = std::array<float, 6>;

struct LitMatter {
    std::vector<float> extinctionPerMm;  // by cell: the mean over its samples that are shown
    std::vector<float> opacity;          // by cell: of a cube as large
    std::vector<SideLight> light;        // by cell

    // How much of a cell is seen from outside, on average over sides.
    float openness(std::size_t cell) const;
};
// How opacity rises around a cell, along the axes of the grid: for a whole cell's more on one side than on
// the other, 1.
inline constexpr float kSurfaceRise = 0.1f;  // of less, there is no surface
glm::vec3 riseAround(const CoarseMatter& matter, const LitMatter& lit, std::size_t cell);
// The light that falls on the surface that a cell is part of: a cell outside of it. Else its own.
SideLight lightOn(const CoarseMatter& matter, const LitMatter& lit, std::size_t cell);
// On all cores.
LitMatter litMatter(const CoarseMatter& matter, const ShownMatter& shown);

// The part of diffuse light that a half space of isotropic scatterers of that albedo reflects, by channel:
// the diffusive reflectance of Hapke 1981, "Bidirectional reflectance spectroscopy 1". An albedo of 1
// reflects all.
glm::vec3 reflectanceOf(const glm::vec3& albedo);

// Linear radiance that leaves white matter for light of 1 from each side, and whatever the light.
struct LightOfSides {
    std::array<glm::vec3, 7> radiance{};

    glm::vec3 at(const SideLight& light) const;
};

// Of an environment in the patient's frame, as matter of a volume with those axes meets it: a surface is lit
// from three sides.
LightOfSides lightOf(const trace::Environment& environment, const glm::dmat3& worldFromVoxel);

struct LitSample {
    SideLight light;
    glm::vec3 reflectance;
    glm::vec3 radiance;  // linear, that leaves matter of it there
    float weight;
};
// The non-negative light that explains the samples' radiance with the least squares. Sides that samples say
// little about stay near to `expected`.
LightOfSides fittedLight(std::span<const LitSample> samples, const LightOfSides& expected);

}  // namespace macula::hybrid
