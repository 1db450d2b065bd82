// Made-up people on made-up tables, of which it is known what is which.
#pragma once

#include "base/volume.h"
#include "segment/patient.h"

namespace macula::segment::test {

enum class Lying { supine, prone, onTheSide };
enum class Body { trunk, trunkWithArms, legs };

// HU of foam; none: nothing lies between the person and the table's upper sheet.
struct Scene {
    Lying lying = Lying::supine;
    Body body = Body::trunk;
    bool table = true;
    double gapMm = 6.0;     // between the person and what lies below
    double sunkMm = 0.0;    // how much of the person the table flattens, when gapMm is 0
    double bowlMm = 0.0;    // how far the table's edges stand above its middle
    double foamHu = -1000;  // of a mattress 30 mm thick below the person
    glm::ivec3 size{330, 280, 48};
    glm::dmat4 worldFromVoxel{1.0};  // of the scene's middle; set by `made` when it is the identity
};

struct Made {
    Volume volume;
    std::vector<std::uint8_t> person;
    std::vector<std::uint8_t> table;  // its sheets; of foam only what is denser than -200 HU
};

Made make(const Scene& scene);
PatientMask find(const Volume& volume);  // fails the test on an error

// Of what is not air.
double dice(const Made& made, const PatientMask& found);
double tableRemoved(const Made& made, const PatientMask& found);  // share of its voxels

}  // namespace macula::segment::test
