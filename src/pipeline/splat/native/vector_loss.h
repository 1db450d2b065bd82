// shaders/lib/splat_loss.glsl and splat_ssim.glsl as C++ for a vector of pixels, and sums over SSIM windows,
// for native kernels. Compiled once for each instruction set.
#if defined(MACULA_SPLAT_VECTOR_LOSS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MACULA_SPLAT_VECTOR_LOSS_H
#undef MACULA_SPLAT_VECTOR_LOSS_H
#else
#define MACULA_SPLAT_VECTOR_LOSS_H
#endif

#include "base/vector_in_glsl.h"
#include "pipeline/splat/native/native_loss_work.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {

using namespace macula::HWY_NAMESPACE;

#define float Float
#define bool Mask

struct VectorLoss : GlslInVectors {
#include "lib/tone_neutral.glsl"

#include "lib/splat_loss.glsl"
};

// A lane is a channel of a pixel here.
struct VectorSsim : GlslInVectors {
    using vec4 = Float;

#include "lib/splat_ssim.glsl"
};

#undef float
#undef bool
#undef MOST_COMPARED
#undef PLAIN_SHARE
#undef TONE_DESATURATION
#undef SSIM_C1
#undef SSIM_C2

HWY_INLINE Vec4 loadPixels(const float* from) {
    Vec4 v;
    hn::LoadInterleaved4(FloatTag(), from, v.x.values, v.y.values, v.z.values, v.w.values);
    return v;
}
HWY_INLINE void storePixels(Vec4 v, float* to) {
    hn::StoreInterleaved4(v.x.values, v.y.values, v.z.values, v.w.values, FloatTag(), to);
}
HWY_INLINE Vec4 mix(Vec4 a, Vec4 b, Mask isSecond) {
    return {GlslInVectors::mix(a.x, b.x, isSecond), GlslInVectors::mix(a.y, b.y, isSecond),
            GlslInVectors::mix(a.z, b.z, isSecond), GlslInVectors::mix(a.w, b.w, isSecond)};
}
HWY_INLINE Mask isFinite(Vec4 v) {
    return Mask(hn::IsFinite(v.x.values)) && Mask(hn::IsFinite(v.y.values)) &&
           Mask(hn::IsFinite(v.z.values)) && Mask(hn::IsFinite(v.w.values));
}

// A vector of a row of `count` numbers, from `at` on: 0 beyond its end. Where a row does not end with a
// vector, there are AVX2 or AVX-512, which read no more than they are told to: a pixel has a multiple of four
// numbers.
HWY_INLINE Float loadOf(const float* row, std::size_t at, std::size_t count) {
    if (at + kLanes <= count) return Float::load(row + at);
    return hn::MaskedLoad(hn::FirstN(FloatTag(), count - at), FloatTag(), row + at);
}

// The taps of a window from its middle on.
struct WindowTaps {
    std::array<Float, kWindowReach + 1> taps;
};
HWY_INLINE WindowTaps windowTaps() {
    WindowTaps result;
    for (int n = 0; n <= kWindowReach; ++n)
        result.taps[static_cast<std::size_t>(n)] = VectorSsim().ssimTap(n);
    return result;
}

// Weighted sums over the rows of a window, and of the squares unless `squares` is null.
HWY_INLINE void sumColumns(const WindowTaps& window, const WindowRows& rows, std::size_t count, float* sums,
                           float* squares) {
    for (std::size_t at = 0; at < count; at += kLanes) {
        const Float middle = loadOf(rows[kWindowReach], at, count);
        Float sum = window.taps[0] * middle;
        Float square = window.taps[0] * (middle * middle);
        for (std::size_t n = 1; n <= kWindowReach; ++n) {
            const Float above = loadOf(rows[kWindowReach - n], at, count);
            const Float below = loadOf(rows[kWindowReach + n], at, count);
            sum += window.taps[n] * (above + below);
            square += window.taps[n] * (above * above + below * below);
        }
        sum.store(sums + at);
        if (squares != nullptr) square.store(squares + at);
    }
}

// The sum over the columns of a window, of numbers whose pixels are `step` apart.
HWY_INLINE Float sumOfRow(const WindowTaps& window, const float* middle, std::size_t step) {
    Float sum = window.taps[0] * Float::load(middle);
    for (std::size_t n = 1; n <= kWindowReach; ++n)
        sum += window.taps[n] * (Float::load(middle - n * step) + Float::load(middle + n * step));
    return sum;
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
