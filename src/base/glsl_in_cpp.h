// The types and functions of GLSL in C++, in one precision, that shaders/lib needs to compile as members of a
// class derived from this. Members instead of a namespace, because the shader functions read their tables and
// parameters as globals: in C++ those are the members of the class that includes them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>

namespace macula {

template <class Real>
struct GlslInCpp {
    using uint = std::uint32_t;
    using vec2 = glm::vec<2, Real>;
    using vec3 = glm::vec<3, Real>;
    using vec4 = glm::vec<4, Real>;
    using bvec2 = glm::bvec2;
    using bvec3 = glm::bvec3;
    using ivec2 = glm::ivec2;
    using ivec3 = glm::ivec3;
    using uvec2 = glm::uvec2;
    using uvec4 = glm::uvec4;

    static Real min(Real a, Real b) { return b < a ? b : a; }
    static int min(int a, int b) { return b < a ? b : a; }
    static vec3 min(const vec3& a, const vec3& b) { return glm::min(a, b); }
    static vec4 min(const vec4& a, const vec4& b) { return glm::min(a, b); }
    static ivec3 min(const ivec3& a, const ivec3& b) { return glm::min(a, b); }
    static Real max(Real a, Real b) { return a < b ? b : a; }
    static int max(int a, int b) { return a < b ? b : a; }
    static vec4 max(const vec4& a, const vec4& b) { return glm::max(a, b); }
    static vec3 max(const vec3& a, const vec3& b) { return glm::max(a, b); }
    static Real clamp(Real x, Real low, Real high) { return min(max(x, low), high); }
    static int clamp(int x, int low, int high) { return min(max(x, low), high); }
    static vec3 clamp(const vec3& x, const vec3& low, const vec3& high) { return glm::clamp(x, low, high); }
    static vec2 clamp(const vec2& x, const vec2& low, const vec2& high) { return glm::clamp(x, low, high); }
    static vec4 clamp(const vec4& x, const vec4& low, const vec4& high) { return glm::clamp(x, low, high); }
    static ivec2 clamp(const ivec2& x, const ivec2& low, const ivec2& high) {
        return glm::clamp(x, low, high);
    }
    static ivec3 clamp(const ivec3& x, const ivec3& low, const ivec3& high) {
        return glm::clamp(x, low, high);
    }
    static Real mix(Real a, Real b, Real t) { return a * (Real(1) - t) + b * t; }
    static vec3 mix(const vec3& a, const vec3& b, Real t) { return glm::mix(a, b, t); }
    static Real mix(Real a, Real b, bool isSecond) { return isSecond ? b : a; }
    static vec2 mix(const vec2& a, const vec2& b, const bvec2& isSecond) { return glm::mix(a, b, isSecond); }
    static vec3 mix(const vec3& a, const vec3& b, const bvec3& isSecond) { return glm::mix(a, b, isSecond); }
    static Real abs(Real x) { return std::abs(x); }
    static vec4 abs(const vec4& x) { return glm::abs(x); }
    static Real floor(Real x) { return std::floor(x); }
    static vec2 floor(const vec2& x) { return {std::floor(x.x), std::floor(x.y)}; }
    static vec3 floor(const vec3& x) { return {std::floor(x.x), std::floor(x.y), std::floor(x.z)}; }
    static Real ceil(Real x) { return std::ceil(x); }
    static Real sqrt(Real x) { return std::sqrt(x); }
    static Real log(Real x) { return std::log(x); }
    static Real exp(Real x) { return std::exp(x); }
    static Real pow(Real x, Real y) { return std::pow(x, y); }
    static Real sin(Real x) { return std::sin(x); }
    static Real cos(Real x) { return std::cos(x); }
    static Real acos(Real x) { return std::acos(x); }
    static Real atan(Real y, Real x) { return std::atan2(y, x); }
    static Real dot(const vec2& a, const vec2& b) { return glm::dot(a, b); }
    static Real dot(const vec3& a, const vec3& b) { return glm::dot(a, b); }
    static Real dot(const vec4& a, const vec4& b) { return glm::dot(a, b); }
    static vec3 normalize(const vec3& x) { return glm::normalize(x); }
    static bvec3 greaterThanEqual(const vec3& a, const vec3& b) { return glm::greaterThanEqual(a, b); }
    static bvec3 lessThanEqual(const vec3& a, const vec3& b) { return glm::lessThanEqual(a, b); }
    static uint floatBitsToUint(Real x) { return std::bit_cast<uint>(static_cast<float>(x)); }
    static uint bitfieldReverse(uint x) { return glm::bitfieldReverse(x); }
    static bool all(const bvec3& x) { return x.x && x.y && x.z; }
};

}  // namespace macula
