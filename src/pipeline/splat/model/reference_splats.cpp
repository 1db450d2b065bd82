#include "pipeline/splat/model/reference_splats.h"

namespace macula::splat {

ReferenceSplats::ReferenceSplats(std::size_t count, int degree)
    : shDegree(degree),
      position(count, glm::dvec3(0.0)),
      logScale(count, glm::dvec3(0.0)),
      rotation(count, glm::dvec4(0.0)),
      opacityLogit(count, 0.0),
      dc(count, glm::dvec3(0.0)),
      sh(count * shCount(degree), glm::dvec3(0.0)) {}

ReferenceSplats::ReferenceSplats(const Splats& splats)
    : shDegree(splats.shDegree),
      position(splats.position.begin(), splats.position.end()),
      logScale(splats.logScale.begin(), splats.logScale.end()),
      rotation(splats.rotation.begin(), splats.rotation.end()),
      opacityLogit(splats.opacityLogit.begin(), splats.opacityLogit.end()),
      dc(splats.dc.begin(), splats.dc.end()),
      sh(splats.sh.begin(), splats.sh.end()) {}

}  // namespace macula::splat
