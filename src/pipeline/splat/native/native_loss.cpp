#include "pipeline/splat/native/native_loss.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/native/native_loss.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <vector>

#include "base/parallel.h"
#include "pipeline/splat/native/native_loss_work.h"
#include "pipeline/splat/native/vector_loss.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {
namespace {

// The four numbers of a pixel.
using PixelTag = hn::CappedTag<float, 4>;
HWY_INLINE void copyPixel(const float* from, float* to) {
    const PixelTag tag;
    for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) hn::StoreU(hn::LoadU(tag, from + k), tag, to + k);
}

struct Parameters {
    HWY_INLINE explicit Parameters(const shared::SplatLossParams& params)
        : background(params.background.x, params.background.y, params.background.z),
          exposure(params.exposure),
          isSquared(params.squareScale > 0.0f),
          coverageOnly(params.coverageOnly != 0u) {}

    Vec3 background;
    Float exposure;
    bool isSquared;
    bool coverageOnly;
};

// As pairOf in shaders/splat/loss_setup.glsl.
HWY_INLINE void pairOf(Vec4 render, Vec4 truth, Mask known, const Parameters& params, bool display, Vec4& sum,
                       Vec4& difference) {
    VectorLoss maths;
    render = mix(truth, render, isFinite(render));
    const auto ours = maths.comparedPixel(render, params.background, params.exposure, display);
    const auto theirs = maths.comparedPixel(truth, params.background, params.exposure, display);
    const Vec4 x = ours.value;
    Vec4 y = theirs.value;
    difference = x - y;
    if (params.isSquared) {
        const Vec3 change = maths.comparedChange(ours.over, ours.over - theirs.over, display);
        difference = Vec4(change, difference.w);
    }
    if (params.coverageOnly) {
        y = Vec4(x.x, x.y, x.z, y.w);
        difference = Vec4(Vec3(0.0f), difference.w);
    }
    // Compilers may round x otherwise than y: where the pixels are the same, there is no difference.
    const Mask same =
        render.x == truth.x && render.y == truth.y && render.z == truth.z && render.w == truth.w;
    const Vec4 none(0.0f);
    sum = mix(none, x + y, known);
    difference = mix(none, difference, known && !same);
}

// Whether no pixel of a vector shows anything.
HWY_INLINE bool isEmpty(Vec4 pixels) {
    const Float zero(0.0f);
    const Mask empty = pixels.x == zero && pixels.y == zero && pixels.z == zero && pixels.w == zero;
    return (!empty).none();
}

// The rows that a strip's pixels pass through.
struct CompareRows {
    explicit CompareRows(std::size_t width)
        : rendered(width, 4), targets(width, 4), windows(width, 1), sums(width, 4), differences(width, 4) {}

    PaddedRow rendered, targets, windows, sums, differences;
};

}  // namespace

void compareStrip(const LossCompare& work, std::size_t strip) {
    const std::size_t width = work.of.width;
    const Parameters params(work.of.params);
    const Vec4 empty(0.0f);
    Vec4 sumOfEmpty;
    Vec4 noDifference;
    pairOf(empty, empty, Mask(true), params, work.of.display, sumOfEmpty, noDifference);
    CompareRows rows(width);
    for (std::size_t y = work.of.firstRow(strip); y < work.of.endRow(strip); ++y) {
        rows.rendered.read(work.rendered + y * width * 4, width);
        rows.targets.read(work.targets + y * width * 4, width);
        rows.windows.read(work.windows + y * width, width);
        for (std::size_t x = 0; x < width; x += kLanes) {
            Vec4 sum = sumOfEmpty;
            Vec4 difference = noDifference;
            const Vec4 rendered = loadPixels(rows.rendered.data() + 4 * x);
            const Vec4 target = loadPixels(rows.targets.data() + 4 * x);
            const Mask known = Float::load(rows.windows.data() + x) > Float(0.0f);
            if (!isEmpty(rendered) || !isEmpty(target) || !(!known).none())
                pairOf(rendered, target, known, params, work.of.display, sum, difference);
            storePixels(sum, rows.sums.data() + 4 * x);
            storePixels(difference, rows.differences.data() + 4 * x);
        }
        float* to = work.pairs + y * width * 8;
        for (std::size_t x = 0; x < width; ++x) {
            copyPixel(rows.sums.data() + 4 * x, to + 8 * x);
            copyPixel(rows.differences.data() + 4 * x, to + 8 * x + 4);
        }
    }
}

namespace {

// Pixels of a strip, some tiles of it.
struct Run {
    std::size_t first;
    std::size_t end;
};

// Whether both pictures are the same in a tile and as far around it as windows reach: then nothing in it has
// a part of the loss or a gradient. Much of a picture is empty in both.
HWY_INLINE bool isEqualAround(const LossPicture& of, const float* pairs, std::size_t strip,
                              std::size_t tile) {
    const PixelTag tag;
    const auto zero = hn::Zero(tag);
    const auto before = [](std::size_t at) { return at > kWindowReach ? at - kWindowReach : 0; };
    const std::size_t first = before(tile * kLossTile);
    const std::size_t end = std::min(of.width, (tile + 1) * kLossTile + kWindowReach);
    const std::size_t endRow = std::min(of.height, of.endRow(strip) + kWindowReach);
    for (std::size_t y = before(of.firstRow(strip)); y < endRow; ++y) {
        auto most = zero;
        for (std::size_t x = first; x < end; ++x) {
            const float* const difference = pairs + (y * of.width + x) * 8 + 4;
            for (std::size_t k = 0; k < 4; k += hn::Lanes(tag))
                most = hn::Max(most, hn::Abs(hn::LoadU(tag, difference + k)));
        }
        if (!hn::AllFalse(tag, hn::Gt(most, zero))) return false;
    }
    return true;
}

// The tiles of a strip of which that does not hold, and the others.
struct Runs {
    HWY_INLINE Runs(const LossPicture& of, const float* pairs, std::size_t strip) {
        for (std::size_t tile = 0; tile < of.tiles(); ++tile) {
            std::vector<Run>& runs = isEqualAround(of, pairs, strip, tile) ? equal : different;
            const std::size_t first = tile * kLossTile;
            if (runs.empty() || runs.back().end != first) runs.push_back({first, first});
            runs.back().end = std::min(of.width, first + kLossTile);
        }
    }

    std::vector<Run> different;
    std::vector<Run> equal;
};

// What windows around a run read.
HWY_INLINE Run reachOf(const Run& run, std::size_t width) {
    return {run.first > kWindowReach ? run.first - kWindowReach : 0, std::min(width, run.end + kWindowReach)};
}

// sumColumns() of a run and what its windows read, of `numbers` for each pixel.
HWY_INLINE void sumColumns(const WindowTaps& taps, WindowRows rows, std::size_t numbers, const Run& run,
                           std::size_t width, float* sums, float* squares) {
    const Run reach = reachOf(run, width);
    const std::size_t at = reach.first * numbers;
    for (const float*& row : rows) row += at;
    sumColumns(taps, rows, (reach.end - reach.first) * numbers, sums + at,
               squares == nullptr ? nullptr : squares + at);
}

struct TermRows {
    explicit TermRows(std::size_t width)
        : zeros(width * 8, 0.0f),
          columns(width, 8),
          squares(width, 8),
          u(width, 4),
          v(width, 4),
          uu(width, 4),
          vv(width, 4),
          window(width, 4),
          dissimilarity(width, 4) {}

    std::vector<float> zeros;
    PaddedRow columns, squares, u, v, uu, vv, window, dissimilarity;
};

// Sums a run of columns' sums, and sorts them into those of sums and those of differences.
HWY_INLINE void sumRow(const WindowTaps& taps, float* columns, const Run& run, PaddedRow& ofSums,
                       PaddedRow& ofDifferences) {
    constexpr std::size_t kAtOnce = std::max<std::size_t>(kLanes, 8);  // one or two pixels
    std::array<float, kAtOnce> pixels;
    for (std::size_t at = run.first * 8; at < run.end * 8; at += kAtOnce) {
        for (std::size_t k = 0; k < kAtOnce; k += kLanes)
            sumOfRow(taps, columns + at + k, 8).store(pixels.data() + k);
        for (std::size_t k = 0; k < kAtOnce; k += 8) {
            copyPixel(pixels.data() + k, ofSums.data() + (at + k) / 2);
            copyPixel(pixels.data() + k + 4, ofDifferences.data() + (at + k) / 2);
        }
    }
}

HWY_INLINE void writeTerms(TermRows& rows, const Run& run, float* terms) {
    VectorSsim maths;
    for (std::size_t at = run.first * 4; at < run.end * 4; at += kLanes) {
        const Float window = Float::load(rows.window.data() + at);
        const auto ssim = maths.ssimWindow(
            Float::load(rows.u.data() + at) * window, Float::load(rows.v.data() + at) * window,
            Float::load(rows.uu.data() + at) * window, Float::load(rows.vv.data() + at) * window);
        ssim.dissimilarity.store(rows.dissimilarity.data() + at);
        (ssim.plain * window).store(rows.u.data() + at);
        (ssim.ofSum * window).store(rows.v.data() + at);
        (ssim.ofDifference * window).store(rows.uu.data() + at);
    }
    for (std::size_t x = run.first; x < run.end; ++x) {
        copyPixel(rows.u.data() + 4 * x, terms + 12 * x);
        copyPixel(rows.v.data() + 4 * x, terms + 12 * x + 4);
        copyPixel(rows.uu.data() + 4 * x, terms + 12 * x + 8);
    }
}

// The sum over the 4 kLossTile numbers of a tile's row.
HWY_INLINE float sumOfTile(const float* numbers) {
    Float sum(0.0f);
    for (std::size_t k = 0; k < 4 * kLossTile; k += kLanes) sum += Float::load(numbers + k);
    return hn::GetLane(hn::SumOfLanes(FloatTag(), sum.values));
}

}  // namespace

void sumStrip(const LossTerms& work, std::size_t strip) {
    const std::size_t width = work.of.width;
    const WindowTaps taps = windowTaps();
    TermRows rows(width);
    float* parts = work.parts + strip * work.of.tiles();
    std::fill_n(parts, work.of.tiles(), 0.0f);
    const Runs runs(work.of, work.pairs, strip);
    for (std::size_t y = work.of.firstRow(strip); y < work.of.endRow(strip); ++y) {
        float* const terms = work.terms + y * width * 12;
        for (const Run& run : runs.equal) std::fill(terms + run.first * 12, terms + run.end * 12, 0.0f);
        const WindowRows pairs = windowRows(work.pairs, 8 * width, y, work.of.height, rows.zeros.data());
        for (const Run& run : runs.different) {
            sumColumns(taps, pairs, 8, run, width, rows.columns.data(), rows.squares.data());
            sumRow(taps, rows.columns.data(), run, rows.u, rows.v);
            sumRow(taps, rows.squares.data(), run, rows.uu, rows.vv);
            for (std::size_t x = run.first; x < run.end; ++x)
                std::fill_n(rows.window.data() + 4 * x, 4, work.windows[y * width + x]);
            writeTerms(rows, run, terms);
            for (std::size_t tile = run.first / kLossTile; tile * kLossTile < run.end; ++tile)
                parts[tile] += sumOfTile(rows.dissimilarity.data() + 4 * kLossTile * tile);
        }
    }
}

namespace {

struct GradientRows {
    explicit GradientRows(std::size_t width)
        : zeros(width * 12, 0.0f),
          columns(width, 12),
          sums(width, 12),
          back(width, 4),
          rendered(width, 4),
          windows(width, 1),
          gradients(width, 4) {}

    std::vector<float> zeros;
    PaddedRow columns, sums, back, rendered, windows, gradients;
};

// The derivative by each compared pixel of a run, as in gradientOf of shaders/splat/loss_setup.glsl; adds its
// terms of the loss to the parts of tiles.
HWY_INLINE void writeBack(GradientRows& rows, const LossGradient& work, const Run& run, const float* pairs,
                          float* parts) {
    const PixelTag tag;
    const auto l1 = hn::Set(tag, work.of.params.l1Scale);
    const auto dssim = hn::Set(tag, work.of.params.dssimScale);
    const auto square = hn::Set(tag, 2.0f * work.of.params.squareScale);
    const auto zero = hn::Zero(tag);
    for (std::size_t first = run.first; first < run.end; first += kLossTile) {
        auto absolute = zero;
        auto squares = zero;
        const std::size_t end = std::min(run.end, first + kLossTile);
        for (std::size_t x = first; x < end; ++x) {
            for (std::size_t k = 0; k < 4; k += hn::Lanes(tag)) {
                const auto sum = hn::LoadU(tag, pairs + 8 * x + k);
                const auto difference = hn::LoadU(tag, pairs + 8 * x + 4 + k);
                const float* terms = rows.sums.data() + 12 * x + k;
                const auto similarity =
                    hn::MulAdd(hn::LoadU(tag, terms + 4), sum,
                               hn::MulAdd(hn::LoadU(tag, terms + 8), difference, hn::LoadU(tag, terms)));
                const auto sign = hn::IfThenZeroElse(hn::Eq(difference, zero), hn::CopySign(l1, difference));
                const auto back = hn::MulAdd(dssim, similarity, hn::MulAdd(square, difference, sign));
                hn::StoreU(back, tag, rows.back.data() + 4 * x + k);
                absolute = hn::Add(absolute, hn::Abs(difference));
                squares = hn::MulAdd(difference, difference, squares);
            }
        }
        float* const part = parts + first / kLossTile * 4;
        part[0] += hn::GetLane(hn::SumOfLanes(tag, absolute));
        part[1] += hn::GetLane(hn::SumOfLanes(tag, squares));
    }
}

// Counts the rendered pixels of tiles that are not finite.
HWY_INLINE void countBad(Mask finite, std::size_t x, float* parts) {
    parts[x / kLossTile * 4 + 2] += static_cast<float>(kLanes - hn::CountTrue(FloatTag(), finite.bits));
}

// Takes the derivative back to the premultiplied pixels of a run.
HWY_INLINE void writeGradients(GradientRows& rows, const LossGradient& work, const Run& run, float* parts) {
    VectorLoss maths;
    const Parameters params(work.of.params);
    for (std::size_t x = run.first; x < run.end; x += kLanes) {
        const Vec4 render = loadPixels(rows.rendered.data() + 4 * x);
        const Mask finite = isFinite(render);
        const Mask known = Float::load(rows.windows.data() + x) > Float(0.0f);
        const Vec3 over =
            maths.comparedPixel(render, params.background, params.exposure, work.of.display).over;
        const Vec4 gradient = maths.comparedPixelBack(over, loadPixels(rows.back.data() + 4 * x),
                                                      params.background, params.exposure, work.of.display);
        storePixels(mix(Vec4(0.0f), gradient, known && finite), rows.gradients.data() + 4 * x);
        countBad(finite, x, parts);
    }
}

}  // namespace

void differentiateStrip(const LossGradient& work, std::size_t strip) {
    const std::size_t width = work.of.width;
    const WindowTaps taps = windowTaps();
    GradientRows rows(width);
    float* parts = work.parts + strip * work.of.tiles() * 4;
    std::fill_n(parts, work.of.tiles() * 4, 0.0f);
    const Runs runs(work.of, work.pairs, strip);
    for (std::size_t y = work.of.firstRow(strip); y < work.of.endRow(strip); ++y) {
        rows.rendered.read(work.rendered + y * width * 4, width);
        rows.windows.read(work.windows + y * width, width);
        float* const gradients = work.gradients + y * width * 4;
        for (const Run& run : runs.equal) {
            for (std::size_t x = run.first; x < run.end; x += kLanes)
                countBad(isFinite(loadPixels(rows.rendered.data() + 4 * x)), x, parts);
            std::fill(gradients + run.first * 4, gradients + run.end * 4, 0.0f);
        }
        for (const Run& run : runs.different) {
            if (work.of.similar) {
                const WindowRows terms =
                    windowRows(work.terms, 12 * width, y, work.of.height, rows.zeros.data());
                sumColumns(taps, terms, 12, run, width, rows.columns.data(), nullptr);
                for (std::size_t at = run.first * 12; at < run.end * 12; at += kLanes)
                    sumOfRow(taps, rows.columns.data() + at, 12).store(rows.sums.data() + at);
            }
            writeBack(rows, work, run, work.pairs + y * width * 8, parts);
            writeGradients(rows, work, run, parts);
            std::copy(rows.gradients.data() + run.first * 4, rows.gradients.data() + run.end * 4,
                      gradients + run.first * 4);
        }
    }
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(compareStrip);
HWY_EXPORT(sumStrip);
HWY_EXPORT(differentiateStrip);

namespace {

void compare(const LossCompare& work) {
    parallelFor(work.of.strips(), [&](std::size_t strip) {
        HWY_DYNAMIC_DISPATCH(compareStrip)(work, strip);
    });
}

LossCompare compareOf(const gpu::NativeDispatch& dispatch, bool display) {
    LossCompare work{LossPicture(dispatch), dispatch.binding<const float>(1).data(),
                     dispatch.binding<const float>(2).data(), dispatch.binding<const float>(3).data(),
                     dispatch.binding<float>(4).data()};
    work.of.display = display;
    return work;
}

}  // namespace

gpu::NativeKernel nativeLossCompare(bool display) {
    return [display](const gpu::NativeDispatch& dispatch) { compare(compareOf(dispatch, display)); };
}

gpu::NativeKernel nativeLossTerms(bool display) {
    return [display](const gpu::NativeDispatch& dispatch) {
        // All pixels first: windows reach into the strips above and below.
        const LossCompare compared = compareOf(dispatch, display);
        compare(compared);
        const LossTerms work{compared.of, compared.windows, compared.pairs, dispatch.binding<float>(5).data(),
                             dispatch.binding<float>(6).data()};
        parallelFor(work.of.strips(), [&](std::size_t strip) {
            HWY_DYNAMIC_DISPATCH(sumStrip)(work, strip);
        });
    };
}

gpu::NativeKernel nativeLossGradient(bool display, bool similar) {
    return [display, similar](const gpu::NativeDispatch& dispatch) {
        LossGradient work{LossPicture(dispatch),
                          dispatch.binding<const float>(1).data(),
                          dispatch.binding<const float>(2).data(),
                          dispatch.binding<const float>(3).data(),
                          dispatch.binding<const float>(4).data(),
                          dispatch.binding<float>(5).data(),
                          dispatch.binding<float>(6).data()};
        work.of.display = display;
        work.of.similar = similar;
        parallelFor(work.of.strips(), [&](std::size_t strip) {
            HWY_DYNAMIC_DISPATCH(differentiateStrip)(work, strip);
        });
    };
}

}  // namespace macula::splat
#endif
