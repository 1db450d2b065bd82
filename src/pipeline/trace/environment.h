// Light from all directions, as a table the tracer can look up and sample.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/result.h"

namespace macula::trace {

enum class LightFrame { patient, camera };

// A disc of constant radiance on the sky, soft at its rim. Angles in the rig's frame. Patient: azimuth 0 is
// anterior, positive towards the patient's left; elevation up is superior. Camera: azimuth 0 is behind the
// viewer, positive to the right of the picture; elevation up is up in the picture.
struct SoftLight {
    double azimuthDeg = 0.0;
    double elevationDeg = 0.0;
    double angularRadiusDeg = 20.0;
    glm::dvec3 colour{1.0};  // linear
    double radiance = 1.0;

    bool operator==(const SoftLight&) const = default;
};

// A built-in or user-made arrangement of lights over an ambient sky. Radiance is linear; 1 on a white surface
// is white.
struct LightRig {
    std::string name;
    std::string title;
    LightFrame frame = LightFrame::patient;
    glm::dvec3 ambientZenith{0.0};
    glm::dvec3 ambientHorizon{0.0};
    glm::dvec3 ambientNadir{0.0};
    std::vector<SoftLight> lights;

    bool operator==(const LightRig&) const = default;
};

struct EnvironmentTexel {
    glm::vec3 radiance{0.0f};
    float pdfPerSr = 0.0f;  // of sampling a direction in this texel, per steradian: the Jacobian is in it

    bool operator==(const EnvironmentTexel&) const = default;
};

// Equirectangular, piecewise constant per texel, laid out as a panorama that is looked at from inside. Frame:
// y up and, for patient rigs, (x, y, z) = (Left, Superior, Anterior); for camera rigs x right in the picture
// and z towards the viewer. Row 0 is the zenith; the middle column is at +z, and columns grow to the right as
// seen from inside: towards -x. Rows are uniform in the polar angle, so solid angles shrink towards the
// poles; they are computed exactly.
class Environment {
  public:
    static constexpr int kMaxWidth = 1024;

    // `radiance` has width * height RGB triples, row 0 at the zenith. Pictures larger than kMaxWidth on a
    // side are averaged down, weighted by solid angle, so that their energy stays. Fails with inputNotUsable
    // for an empty, negative or non-finite one.
    static Result<Environment> fromImage(int width, int height, std::span<const glm::vec3> radiance,
                                         LightFrame frame = LightFrame::patient);
    static Environment fromRig(const LightRig& rig);
    static Environment constant(const glm::vec3& radiance);

    int width() const { return width_; }
    int height() const { return height_; }
    LightFrame frame() const { return frame_; }
    std::span<const EnvironmentTexel> texels() const { return texels_; }
    // The cumulative distribution for importance sampling of texels by power: for each row, where its share
    // of the unit interval begins; after the rows, for each texel, where its share of its row begins.
    std::span<const float> cumulative() const { return cumulative_; }

    // The luminance (Rec. 709) of its light, averaged over all directions.
    double meanLuminance() const { return meanLuminance_; }

    bool operator==(const Environment&) const = default;

  private:
    int width_ = 0;
    int height_ = 0;
    LightFrame frame_ = LightFrame::patient;
    double meanLuminance_ = 0.0;
    std::vector<EnvironmentTexel> texels_;
    std::vector<float> cumulative_;
};

}  // namespace macula::trace
