// Volumes whose values are known, and the plain way to look at them.
#pragma once

#include <glm/glm.hpp>
#include <random>
#include <string>
#include <vector>

#include "base/volume.h"
#include "slices/slice_plane.h"

namespace macula::slices::test {

using Random = std::mt19937;

struct Pose {
    std::string name;
    glm::dmat4 worldFromVoxel;
};
// Every way in which slices are taken: axial, coronal, sagittal, tilted, oblique, sheared, mirrored.
std::vector<Pose> poses();

// What of the voxels is padding: none, or about a fifth of them (for floats half of these NaN).
enum class Padding { none, some };
// Values of chance. Stored: from 24 on, less 1024, padding below 24.
Volume storedVolume(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, Padding padding);
Volume floatVolume(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, Padding padding);
// Float, with the values given, i fastest.
Volume volumeOf(const glm::ivec3& size, const glm::dmat4& worldFromVoxel, std::vector<float> values);

glm::dvec3 middleMm(const Volume& volume);
double uniform(Random& random, double low, double high);
glm::dvec3 randomPointMm(const Volume& volume, Random& random);
glm::ivec3 randomVoxel(const Volume& volume, Random& random);
SlicePlane randomPlane(const glm::dvec3& centreMm, Random& random);

// Straight from Volume::value, and slow: linear, padding left out, NaN where there is nothing.
double valueAt(const Volume& volume, const glm::dvec3& mm);
// So near to where valueAt jumps or forgets a voxel that rounding decides.
bool isAtJump(const Volume& volume, const glm::dvec3& mm);

}  // namespace macula::slices::test
