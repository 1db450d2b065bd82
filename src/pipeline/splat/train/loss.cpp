#include "pipeline/splat/train/loss.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/check.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/splat/native/native_loss.h"
#include "shaders/splat.h"

namespace macula::splat {

namespace {

// Pixels of a strip, see shaders/splat/loss_strips.glsl. Measured on lavapipe: 20 ms at 512 x 512; rows of 16
// are 1 ms faster, but take 0.5 s longer to compile. On a GPU, as many sums as fit its registers.
constexpr int kColumnOutputs = 4;
constexpr int kRowOutputsCpu = 8;
constexpr int kRowOutputsGpu = 4;

// Edge in pixels of a workgroup's tile: kTile in shaders/splat/loss_tile.glsl.
constexpr int kTile = 16;
constexpr std::uint32_t kTileSharedBytes = 32768;  // the shared memory of its largest kernel, rounded up

constexpr VkBufferUsageFlags kReadAndWritten =
    VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT;

std::uint32_t stripsOf(int pixels, int outputs) {
    return static_cast<std::uint32_t>((pixels + outputs - 1) / outputs);
}

std::uint64_t pixelsOf(int width, int height) {
    return std::uint64_t(width) * std::uint64_t(height);
}

gpu::Threads threadsOf(int width, int height) {
    return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

Result<gpu::Buffer> makeParams(const std::shared_ptr<gpu::Device>& device) {
    return gpu::Buffer::create(device,
                               {.label = "loss parameters", .bytes = sizeof(shared::SplatLossParams)});
}

void write(gpu::Recorder& recorder, const gpu::Buffer& buffer, const shared::SplatLossParams& params) {
    recorder.update(buffer, std::as_bytes(std::span(&params, 1)));
}

}  // namespace

LossWork lossWorkOf(const gpu::Device& device) {
    const bool fits = device.info().maxSharedBytes >= kTileSharedBytes;
    // Only tiles have native kernels.
    return fits && (!device.isCpu() || device.runsNatively()) ? LossWork::byTiles : LossWork::byStrips;
}

Result<std::shared_ptr<const LossKernels>> LossKernels::create(const std::shared_ptr<gpu::Device>& device,
                                                               LossWork work) {
    const auto make = [&](const gpu::ShaderCode& code, std::vector<gpu::Specialization> specializations,
                          gpu::NativeKernel native = {}) {
        return gpu::Kernel::create(
            device, code, {.specializations = std::move(specializations), .native = std::move(native)});
    };
    const auto forEncodings = [&](const gpu::ShaderCode& code, const auto& native) -> Result<ByEncoding> {
        MACULA_TRY(gpu::Kernel plain, make(code, {{"kDisplay", false}}, native(false)));
        MACULA_TRY(gpu::Kernel display, make(code, {{"kDisplay", true}}, native(true)));
        return ByEncoding{std::move(plain), std::move(display)};
    };
    const int rowOutputs = device->isCpu() ? kRowOutputsCpu : kRowOutputsGpu;
    const auto makeSimilarity = [&]() -> Result<Similarity> {
        if (work == LossWork::byTiles) {
            MACULA_TRY(ByEncoding terms, forEncodings(shaders::splat_loss_tile_terms_comp, nativeLossTerms));
            return Similarity(Tiles{std::move(terms)});
        }
        MACULA_TRY(gpu::Kernel columns,
                   make(shaders::splat_loss_columns_comp, {{"kOutputs", kColumnOutputs}}));
        MACULA_TRY(gpu::Kernel rows, make(shaders::splat_loss_rows_comp, {{"kOutputs", rowOutputs}}));
        MACULA_TRY(gpu::Kernel backColumns,
                   make(shaders::splat_loss_back_columns_comp, {{"kOutputs", kColumnOutputs}}));
        return Similarity(Strips{rowOutputs, std::move(columns), std::move(rows), std::move(backColumns)});
    };
    const auto makeGradient = [&](bool display, bool similar) {
        return work == LossWork::byTiles
                   ? make(shaders::splat_loss_tile_gradient_comp,
                          {{"kDisplay", display}, {"kSimilar", similar}},
                          nativeLossGradient(display, similar))
                   : make(shaders::splat_loss_gradient_comp,
                          {{"kOutputs", rowOutputs}, {"kDisplay", display}, {"kSimilar", similar}});
    };
    MACULA_TRY(auto similarity, makeSimilarity());
    MACULA_TRY(gpu::Kernel windows, make(shaders::splat_loss_windows_comp, {}));
    MACULA_TRY(ByEncoding compare, forEncodings(shaders::splat_loss_compare_comp, nativeLossCompare));
    MACULA_TRY(gpu::Kernel gradientPlain, makeGradient(false, false));
    MACULA_TRY(gpu::Kernel gradientPlainSimilar, makeGradient(false, true));
    MACULA_TRY(gpu::Kernel gradientDisplay, makeGradient(true, false));
    MACULA_TRY(gpu::Kernel gradientDisplaySimilar, makeGradient(true, true));
    MACULA_TRY(gpu::Kernel total, make(shaders::splat_loss_total_comp, {{"kSimilar", false}}));
    MACULA_TRY(gpu::Kernel totalSimilar, make(shaders::splat_loss_total_comp, {{"kSimilar", true}}));
    MACULA_TRY(gpu::Kernel downsample, make(shaders::splat_downsample_comp, {}));
    return std::make_shared<const LossKernels>(
        LossKernels{.similarity = std::move(similarity),
                    .windows = std::move(windows),
                    .compare = std::move(compare),
                    .gradient = {{{std::move(gradientPlain), std::move(gradientPlainSimilar)},
                                  {std::move(gradientDisplay), std::move(gradientDisplaySimilar)}}},
                    .total = {std::move(total), std::move(totalSimilar)},
                    .downsample = std::move(downsample)});
}

Result<LossTarget> LossTarget::create(const LossKernels& kernels, DevicePicture picture) {
    const auto& device = picture.texels.buffer().device();
    MACULA_TRY(gpu::TexelBuffer windows,
               gpu::TexelBuffer::create(device, {.label = "SSIM windows",
                                                 .elements = pixelsOf(picture.width, picture.height),
                                                 .format = VK_FORMAT_R32_SFLOAT,
                                                 .usage = kReadAndWritten}));
    MACULA_TRY(const gpu::Buffer params, makeParams(device));
    MACULA_TRY(auto recorder, gpu::Recorder::create(device, "loss target"));
    write(recorder, params, {.imageSize = {picture.width, picture.height}});
    recorder.dispatch(kernels.windows, threadsOf(picture.width, picture.height),
                      {params, picture.texels, windows.buffer()});
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    return LossTarget(std::move(picture), std::move(windows));
}

Result<std::uint64_t> LossTarget::unknownPixels() const {
    MACULA_TRY(const std::vector<float> windows, gpu::read<float>(windows_.buffer()));
    return static_cast<std::uint64_t>(std::count(windows.begin(), windows.end(), 0.0f));
}

Loss::Loss(std::shared_ptr<const LossKernels> kernels, gpu::Buffer params,
           std::array<gpu::TexelBuffer, 5> scratch, DevicePicture gradient, gpu::Buffer result)
    : kernels_(std::move(kernels)),
      params_(std::move(params)),
      pairs_(std::move(scratch[0])),
      means_(std::move(scratch[1])),
      terms_(std::move(scratch[2])),
      ssimParts_(std::move(scratch[3])),
      differenceParts_(std::move(scratch[4])),
      gradient_(std::move(gradient)),
      result_(std::move(result)) {}

Result<Loss> Loss::create(const std::shared_ptr<gpu::Device>& device,
                          std::shared_ptr<const LossKernels> kernels, std::uint64_t mostPixels) {
    MACULA_CHECK_LE(mostPixels, std::uint64_t(std::numeric_limits<int>::max()));
    MACULA_TRY(DevicePicture gradient,
               DevicePicture::create(device, "gradient of the picture", static_cast<int>(mostPixels), 1));
    const auto make = [&](const char* label, std::uint64_t elements, VkFormat format) {
        return gpu::TexelBuffer::create(
            device, {.label = label, .elements = elements, .format = format, .usage = kReadAndWritten});
    };
    constexpr VkFormat kFour = VK_FORMAT_R32G32B32A32_SFLOAT;
    MACULA_TRY(gpu::TexelBuffer pairs, make("sums and differences", 2 * mostPixels, kFour));
    const bool hasMeans = std::holds_alternative<LossKernels::Strips>(kernels->similarity);
    MACULA_TRY(gpu::TexelBuffer means, make("means over windows", hasMeans ? 4 * mostPixels : 1, kFour));
    MACULA_TRY(gpu::TexelBuffer terms, make("terms of windows", 3 * mostPixels, kFour));
    // A picture one pixel wide has as many strips as pixels. There are fewer tiles than that.
    MACULA_TRY(gpu::TexelBuffer ssimParts, make("parts of SSIM", mostPixels, VK_FORMAT_R32_SFLOAT));
    MACULA_TRY(gpu::TexelBuffer differenceParts, make("parts of differences", mostPixels, kFour));
    MACULA_TRY(gpu::Buffer params, makeParams(device));
    MACULA_TRY(gpu::Buffer result,
               gpu::Buffer::create(device, {.label = "loss",
                                            .bytes = sizeof(shared::SplatLossResult),
                                            .memory = gpu::MemoryKind::readback}));  // read after each step
    return Loss(std::move(kernels), std::move(params),
                {std::move(pairs), std::move(means), std::move(terms), std::move(ssimParts),
                 std::move(differenceParts)},
                std::move(gradient), std::move(result));
}

void Loss::record(gpu::Recorder& recorder, const DevicePicture& render, const LossTarget& target,
                  const LossOptions& options, const LossStep& step) {
    const int width = gradient_.width = render.width;
    const int height = gradient_.height = render.height;
    MACULA_CHECK_LE(pixelsOf(width, height), mostPixels());
    MACULA_CHECK_EQ(target.picture().width, width);
    MACULA_CHECK_EQ(target.picture().height, height);
    MACULA_CHECK(options.dssimWeight >= 0.0f && options.dssimWeight <= 1.0f);
    const bool display = options.encode == LossEncoding::display;
    const std::size_t encode = display ? 1 : 0;
    const gpu::Threads pixels = threadsOf(width, height);
    const auto* strips = std::get_if<LossKernels::Strips>(&kernels_->similarity);
    const auto* tiles = std::get_if<LossKernels::Tiles>(&kernels_->similarity);
    const gpu::Threads rows =
        strips ? gpu::Threads{stripsOf(width, strips->rowOutputs), static_cast<std::uint32_t>(height)}
               : pixels;
    const bool squared = step.measure == LossMeasure::squared;
    const float dssimWeight = step.measure == LossMeasure::similar ? options.dssimWeight : 0.0f;
    const std::size_t similar = dssimWeight > 0.0f ? 1 : 0;
    const float share = step.viewWeight / (4.0f * static_cast<float>(pixelsOf(width, height)));
    write(recorder, params_,
          {.imageSize = {width, height},
           .background = step.background,
           .exposure = display ? options.exposure : 1.0f,
           .l1Scale = squared ? 0.0f : share * (1.0f - dssimWeight),
           .dssimScale = share * dssimWeight,
           .squareScale = squared ? kSquaresWeight * share : 0.0f,
           .partCount = strips ? rows.x * rows.y : stripsOf(width, kTile) * stripsOf(height, kTile),
           .coverageOnly = step.coverageOnly ? 1u : 0u});

    const auto label = recorder.label("loss");
    if (similar != 0 && tiles != nullptr) {
        recorder.dispatch(tiles->terms[encode], pixels,
                          {params_, render.texels, target.picture().texels, target.windows(), pairs_.buffer(),
                           terms_.buffer(), ssimParts_.buffer()});
    } else {
        recorder.dispatch(
            kernels_->compare[encode], pixels,
            {params_, render.texels, target.picture().texels, target.windows(), pairs_.buffer()});
    }
    if (similar != 0 && strips != nullptr) {
        const gpu::Threads columns{static_cast<std::uint32_t>(width), stripsOf(height, kColumnOutputs)};
        recorder.dispatch(strips->columns, columns, {params_, pairs_, means_.buffer()});
        recorder.dispatch(strips->rows, rows,
                          {params_, means_, target.windows(), terms_.buffer(), ssimParts_.buffer()});
        recorder.dispatch(strips->backColumns, columns, {params_, terms_, means_.buffer()});
    }
    const gpu::TexelBuffer& ofWindows = strips ? means_ : terms_;
    recorder.dispatch(kernels_->gradient[encode][similar], rows,
                      {params_, ofWindows, pairs_, target.windows(), render.texels, gradient_.texels.buffer(),
                       differenceParts_.buffer()});
    recorder.dispatch(kernels_->total[similar], {1}, {params_, ssimParts_, differenceParts_, result_});
}

Result<shared::SplatLossResult> Loss::read() const {
    MACULA_TRY(const std::vector<shared::SplatLossResult> results,
               gpu::read<shared::SplatLossResult>(result_));
    return results.front();
}

void recordDownsample(gpu::Recorder& recorder, const LossKernels& kernels, const DevicePicture& from,
                      const DevicePicture& to) {
    MACULA_CHECK_LE(to.width, from.width);
    MACULA_CHECK_LE(to.height, from.height);
    recorder.dispatch(kernels.downsample, threadsOf(to.width, to.height),
                      shared::SplatDownsamplePush{{from.width, from.height}, {to.width, to.height}},
                      {from.texels, to.texels.buffer()});
}

}  // namespace macula::splat
