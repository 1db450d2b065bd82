// The types and functions of GLSL in C++ where `float` is a vector of Google Highway: shaders/lib compiles as
// members of a class derived from GlslInVectors, and one call does as many pixels as a vector has lanes. The
// counterpart of glsl_in_cpp.h.
//
// What is so compiled must have no branches: a comparison has an answer for each lane, a Mask, so that
// mix(a, b, condition) takes the place of ?: and if. Define `float` as Float and `bool` as Mask around the
// inclusion.
//
// Compiled once for each instruction set, hence the guard, which is Highway's.
#if defined(MACULA_BASE_VECTOR_IN_GLSL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_BASE_VECTOR_IN_GLSL_H
#undef MACULA_BASE_VECTOR_IN_GLSL_H
#else
#define MACULA_BASE_VECTOR_IN_GLSL_H
#endif

#include <hwy/highway.h>

#include <cstddef>
#include <cstdint>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace macula::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// At most 16 lanes, all that AVX-512 has.
using FloatTag = hn::CappedTag<float, 16>;
inline constexpr std::size_t kLanes = hn::MaxLanes(FloatTag());

// An answer for each lane.
struct Mask {
    using Bits = decltype(hn::Lt(hn::Zero(FloatTag()), hn::Zero(FloatTag())));

    Bits bits;

    Mask() = default;
    HWY_INLINE Mask(Bits b) : bits(b) {}
    // The same for all lanes.
    HWY_INLINE Mask(bool all) : bits(hn::Lt(hn::Zero(FloatTag()), hn::Set(FloatTag(), all ? 1.0f : 0.0f))) {}
    // For `if` of what is the same for all lanes, as a parameter is.
    HWY_INLINE explicit operator bool() const { return !none(); }

    HWY_INLINE friend Mask operator&&(Mask a, Mask b) { return {hn::And(a.bits, b.bits)}; }
    HWY_INLINE friend Mask operator||(Mask a, Mask b) { return {hn::Or(a.bits, b.bits)}; }
    HWY_INLINE friend Mask operator!(Mask a) { return {hn::Not(a.bits)}; }
    HWY_INLINE bool none() const { return hn::AllFalse(FloatTag(), bits); }
};

// A number for each lane.
struct Float {
    using Values = hn::Vec<FloatTag>;

    Values values;

    Float() = default;
    HWY_INLINE Float(Values v) : values(v) {}
    // The same for all lanes.
    template <class Number>
    requires std::is_arithmetic_v<Number> HWY_INLINE Float(Number number)
        : values(hn::Set(FloatTag(), static_cast<float>(number))) {}

    HWY_INLINE static Float load(const float* from) { return hn::LoadU(FloatTag(), from); }
    HWY_INLINE void store(float* to) const { hn::StoreU(values, FloatTag(), to); }

    HWY_INLINE friend Float operator+(Float a, Float b) { return hn::Add(a.values, b.values); }
    HWY_INLINE friend Float operator-(Float a, Float b) { return hn::Sub(a.values, b.values); }
    HWY_INLINE friend Float operator*(Float a, Float b) { return hn::Mul(a.values, b.values); }
    HWY_INLINE friend Float operator/(Float a, Float b) { return hn::Div(a.values, b.values); }
    HWY_INLINE Float operator-() const { return hn::Neg(values); }
    HWY_INLINE Float& operator+=(Float b) { return *this = *this + b; }
    HWY_INLINE Float& operator-=(Float b) { return *this = *this - b; }
    HWY_INLINE Float& operator*=(Float b) { return *this = *this * b; }

    HWY_INLINE friend Mask operator<(Float a, Float b) { return {hn::Lt(a.values, b.values)}; }
    HWY_INLINE friend Mask operator<=(Float a, Float b) { return {hn::Le(a.values, b.values)}; }
    HWY_INLINE friend Mask operator>(Float a, Float b) { return {hn::Gt(a.values, b.values)}; }
    HWY_INLINE friend Mask operator>=(Float a, Float b) { return {hn::Ge(a.values, b.values)}; }
    HWY_INLINE friend Mask operator==(Float a, Float b) { return {hn::Eq(a.values, b.values)}; }
    HWY_INLINE friend Mask operator!=(Float a, Float b) { return {hn::Ne(a.values, b.values)}; }
};

// Bits for each lane.
struct UintBits {
    hn::Vec<hn::RebindToUnsigned<FloatTag>> values;

    HWY_INLINE friend UintBits operator&(UintBits a, std::uint32_t b) {
        return {hn::And(a.values, hn::Set(hn::RebindToUnsigned<FloatTag>(), b))};
    }
    HWY_INLINE friend Mask operator<(UintBits a, std::uint32_t b) {
        const hn::RebindToUnsigned<FloatTag> unsigneds;
        return {hn::RebindMask(FloatTag(), hn::Lt(a.values, hn::Set(unsigneds, b)))};
    }
    HWY_INLINE friend Mask operator!=(UintBits a, std::uint32_t b) {
        const hn::RebindToUnsigned<FloatTag> unsigneds;
        return {hn::RebindMask(FloatTag(), hn::Ne(a.values, hn::Set(unsigneds, b)))};
    }
};

struct Vec2 {
    Float x, y;

    Vec2() = default;
    HWY_INLINE explicit Vec2(Float all) : x(all), y(all) {}
    HWY_INLINE Vec2(Float x_, Float y_) : x(x_), y(y_) {}

    HWY_INLINE friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    HWY_INLINE friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    HWY_INLINE friend Vec2 operator*(Vec2 a, Vec2 b) { return {a.x * b.x, a.y * b.y}; }
    HWY_INLINE friend Vec2 operator*(Vec2 a, Float b) { return {a.x * b, a.y * b}; }
    HWY_INLINE friend Vec2 operator/(Vec2 a, Float b) { return a * (Float(1.0f) / b); }
    HWY_INLINE Vec2& operator+=(Vec2 b) { return *this = *this + b; }
    HWY_INLINE Vec2& operator-=(Vec2 b) { return *this = *this - b; }
};

struct Vec3 {
    Float x, y, z;

    Vec3() = default;
    HWY_INLINE explicit Vec3(Float all) : x(all), y(all), z(all) {}
    HWY_INLINE Vec3(Float x_, Float y_, Float z_) : x(x_), y(y_), z(z_) {}

    HWY_INLINE friend Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    HWY_INLINE friend Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    HWY_INLINE friend Vec3 operator*(Vec3 a, Vec3 b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
    HWY_INLINE friend Vec3 operator*(Vec3 a, Float b) { return {a.x * b, a.y * b, a.z * b}; }
    HWY_INLINE friend Vec3 operator/(Vec3 a, Vec3 b) { return {a.x / b.x, a.y / b.y, a.z / b.z}; }
    HWY_INLINE friend Vec3 operator/(Vec3 a, Float b) { return a * (Float(1.0f) / b); }
    HWY_INLINE Vec3& operator+=(Vec3 b) { return *this = *this + b; }
    HWY_INLINE Vec3& operator-=(Vec3 b) { return *this = *this - b; }
    HWY_INLINE Vec3& operator*=(Float b) { return *this = *this * b; }
};

struct Vec4 {
    Float x, y, z, w;

    Vec4() = default;
    HWY_INLINE explicit Vec4(Float all) : x(all), y(all), z(all), w(all) {}
    HWY_INLINE Vec4(Float x_, Float y_, Float z_, Float w_) : x(x_), y(y_), z(z_), w(w_) {}
    HWY_INLINE Vec4(Vec3 v, Float w_) : x(v.x), y(v.y), z(v.z), w(w_) {}
    HWY_INLINE Vec4(Float x_, Vec3 v) : x(x_), y(v.x), z(v.y), w(v.z) {}

    HWY_INLINE friend Vec4 operator+(Vec4 a, Vec4 b) { return {a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w}; }
    HWY_INLINE friend Vec4 operator-(Vec4 a, Vec4 b) { return {a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w}; }
    HWY_INLINE friend Vec4 operator*(Vec4 a, Float b) { return {a.x * b, a.y * b, a.z * b, a.w * b}; }
    HWY_INLINE friend Vec4 operator/(Vec4 a, Float b) { return a * (Float(1.0f) / b); }
    HWY_INLINE Vec4& operator+=(Vec4 b) { return *this = *this + b; }
};

struct BVec2 {
    Mask x, y;

    HWY_INLINE explicit BVec2(Mask all) : x(all), y(all) {}
};

struct BVec3 {
    Mask x, y, z;

    HWY_INLINE explicit BVec3(Mask all) : x(all), y(all), z(all) {}
};

struct GlslInVectors {
    using uint = std::uint32_t;
    using bvec2 = BVec2;
    using bvec3 = BVec3;
    using vec2 = Vec2;
    using vec3 = Vec3;
    using vec4 = Vec4;

    HWY_INLINE static Float min(Float a, Float b) { return hn::Min(a.values, b.values); }
    HWY_INLINE static Float max(Float a, Float b) { return hn::Max(a.values, b.values); }
    HWY_INLINE static Float clamp(Float x, Float low, Float high) { return min(max(x, low), high); }
    HWY_INLINE static int abs(int x) { return x < 0 ? -x : x; }
    HWY_INLINE static Float abs(Float x) { return hn::Abs(x.values); }
    HWY_INLINE static Float sqrt(Float x) { return hn::Sqrt(x.values); }
    HWY_INLINE static Float dot(Vec3 a, Vec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
    HWY_INLINE static Float dot(Vec4 a, Vec4 b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
    HWY_INLINE static Float mix(Float a, Float b, Mask isSecond) {
        return hn::IfThenElse(isSecond.bits, b.values, a.values);
    }
    HWY_INLINE static Vec2 mix(Vec2 a, Vec2 b, BVec2 isSecond) {
        return {mix(a.x, b.x, isSecond.x), mix(a.y, b.y, isSecond.y)};
    }
    HWY_INLINE static Vec3 mix(Vec3 a, Vec3 b, BVec3 isSecond) {
        return {mix(a.x, b.x, isSecond.x), mix(a.y, b.y, isSecond.y), mix(a.z, b.z, isSecond.z)};
    }
    HWY_INLINE static Vec3 mix(Vec3 a, Vec3 b, Float t) { return a * (Float(1.0f) - t) + b * t; }
    HWY_INLINE static Vec3 max(Vec3 a, Vec3 b) { return {max(a.x, b.x), max(a.y, b.y), max(a.z, b.z)}; }
    HWY_INLINE static Vec2 clamp(Vec2 x, Vec2 low, Vec2 high) {
        return {clamp(x.x, low.x, high.x), clamp(x.y, low.y, high.y)};
    }
    HWY_INLINE static Vec4 clamp(Vec4 x, Vec4 low, Vec4 high) {
        return {clamp(x.x, low.x, high.x), clamp(x.y, low.y, high.y), clamp(x.z, low.z, high.z),
                clamp(x.w, low.w, high.w)};
    }
    HWY_INLINE static UintBits floatBitsToUint(Float x) {
        return {hn::BitCast(hn::RebindToUnsigned<FloatTag>(), x.values)};
    }
    // Within 2 units in the last place or 1e-7, for normal numbers above 0; something finite for others.
    // Without a division, which that of Highway has.
    HWY_INLINE static Float log(Float x) {
        const hn::Rebind<std::int32_t, FloatTag> integers;
        // x = 2^n (1 + f), with 1 + f from the root of 1/2 to that of 2.
        const auto bits = hn::BitCast(integers, x.values);
        const auto power = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(integers, 0x3f3504f3)));
        const Float f = Float(hn::BitCast(FloatTag(), hn::Sub(bits, hn::ShiftLeft<23>(power)))) - Float(1.0f);
        const Float n = hn::ConvertTo(FloatTag(), power);
        Float sum(7.0376836292e-2f);
        for (const float factor : {-1.1514610310e-1f, 1.1676998740e-1f, -1.2420140846e-1f, 1.4249322787e-1f,
                                   -1.6668057665e-1f, 2.0000714765e-1f, -2.4999993993e-1f, 3.3333331174e-1f})
            sum = sum * f + Float(factor);
        const Float square = f * f;
        const Float small = sum * f * square - n * Float(2.12194440e-4f) - Float(0.5f) * square;
        return (small + f) + n * Float(0.693359375f);
    }
    // For x from 0 on; within the range of exp.
    HWY_INLINE static Float pow(Float x, Float y) { return exp(y * log(x)); }

    // Within 2 units in the last place, for x of -80 to 88; beyond them, the value at the nearer one. So it
    // is at least 1.8e-35, and a product with it is no denormal number, which costs a hundred cycles. Half as
    // long as that of Highway: a picture of splats is hardly more than this.
    HWY_INLINE static Float exp(Float x) {
        const hn::Rebind<std::int32_t, FloatTag> integers;
        x = clamp(x, Float(-80.0f), Float(88.0f));
        // x = n ln 2 + r: the sum of x / ln 2 and 1.5 * 2^23 has n in its lowest bits. The first part of ln 2
        // has so few bits that n times it is exact.
        const Float magic(12582912.0f);
        const Float shifted = x * Float(1.44269504f) + magic;
        const Float n = shifted - magic;
        const Float r = x - n * Float(0.693359375f) + n * Float(2.12194440e-4f);
        const Float power = polynomial(r);
        const auto exponent = hn::ShiftLeft<23>(hn::BitCast(integers, shifted.values));
        return hn::BitCast(FloatTag(), hn::Add(hn::BitCast(integers, power.values), exponent));
    }

  private:
    // e^r for |r| up to ln(2) / 2.
    HWY_INLINE static Float polynomial(Float r) {
        Float sum(1.3921215e-3f);
        sum = sum * r + Float(8.3592025e-3f);
        sum = sum * r + Float(4.1666614e-2f);
        sum = sum * r + Float(1.6666625e-1f);
        sum = sum * r + Float(0.5f);
        return (sum * r * r + r) + Float(1.0f);
    }
};

}  // namespace macula::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
