// The denoiser as scalar C++ in double: the same maths (shaders/lib/denoise*.glsl), slow, for tests.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "shared/denoise_params.h"

namespace macula::trace {

// The buffers that the kernels read and write, by pixel, row 0 on top. All have one size.
struct DenoiseGuides {
    std::vector<glm::dvec4> surfaces;  // as shaders/trace/guides.comp writes them
    std::vector<glm::dvec4> matters;
    std::vector<glm::dvec4> motions;
};
struct DenoiseFilm {
    std::vector<glm::dvec4> sums;
    std::vector<std::uint32_t> counts;
    std::vector<double> squares;
};
struct DenoiseRecord {
    std::vector<glm::dvec4> means;
    std::vector<glm::dvec2> moments;
};
struct DenoiseState {
    std::vector<glm::dvec4> colours;
    std::vector<glm::dvec4> noises;
};

// `before` and `memory` belong to the previous view; not read when push.historySamples is 0.
DenoiseRecord denoiseGather(const shared::DenoisePush& push, const DenoiseFilm& film,
                            const DenoiseGuides& now, const DenoiseGuides& before,
                            const DenoiseRecord& memory);
// The masses, and the state before the first pass.
DenoiseState denoisePrepare(const shared::DenoisePush& push, const DenoiseRecord& record,
                            const DenoiseGuides& now, std::vector<glm::dvec4>& masses);
DenoiseState denoiseFilter(const shared::DenoisePush& push, const DenoiseState& state,
                           const DenoiseGuides& now, const std::vector<glm::dvec4>& masses);
// The colours without specks, before the first pass and after the last one.
std::vector<glm::dvec4> denoiseSpecksFirst(const shared::DenoisePush& push, const DenoiseRecord& record,
                                           const DenoiseState& state, const DenoiseGuides& now,
                                           const std::vector<glm::dvec4>& masses);
std::vector<glm::dvec4> denoiseSpecks(const shared::DenoisePush& push, const DenoiseState& state,
                                      const DenoiseGuides& now, const std::vector<glm::dvec4>& masses);
// The mean square error of the luminance of the filtered picture; after the last pass.
std::vector<double> denoiseVariances(const shared::DenoisePush& push, const DenoiseRecord& record,
                                     const DenoiseState& state, const DenoiseGuides& now,
                                     const std::vector<glm::dvec4>& masses);

}  // namespace macula::trace
