// Makes one header valid in both C++ and GLSL. A shared header includes this first and puts its structs
// between the macros:
//
//   #ifndef MACULA_SHARED_TRACE_PARAMS_H
//   #define MACULA_SHARED_TRACE_PARAMS_H
//   #include "shared/shared.h"
//   MACULA_SHARED_BEGIN
//   MACULA_SHARED_CONST uint kMaxBounces = 8u;
//   struct TraceParams {
//       mat4 worldFromView;
//       vec3 lightDirection;
//       float exposure;
//   };
//   MACULA_SHARED_END
//   #endif
//
// In C++ that is macula::shared::TraceParams with tightly packed GLM types. In GLSL use it in blocks declared
// with the layout `scalar` (`layout(push_constant, scalar) uniform Push { TraceParams params; };`): scalar
// layout packs as C++ does, vec3 included. List each struct in a test with expectLayoutMatches
// (tests/gpu/shared_layout.h). Not for shared structs: bool (use uint), double, default values.
#ifndef MACULA_SHARED_SHARED_H
#define MACULA_SHARED_SHARED_H

#ifdef __cplusplus

#include <cstdint>
#include <glm/glm.hpp>

namespace macula::shared {
using uint = std::uint32_t;
using glm::ivec2;
using glm::ivec3;
using glm::ivec4;
using glm::mat3;
using glm::mat4;
using glm::uvec2;
using glm::uvec3;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
}  // namespace macula::shared

#define MACULA_SHARED_BEGIN namespace macula::shared {
#define MACULA_SHARED_END }
#define MACULA_SHARED_CONST inline constexpr

#else

#extension GL_EXT_scalar_block_layout : require

#define MACULA_SHARED_BEGIN
#define MACULA_SHARED_END
#define MACULA_SHARED_CONST const

#endif

#endif
