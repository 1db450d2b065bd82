#include "live/hosted/host_picture.h"

#include <algorithm>
#include <span>
#include <utility>

#include "pipeline/gpu/device.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::live {

namespace {

// A screen that is always visible; pictures keep the size in which they were drawn.
class HostScreen final : public Screen {
  public:
    HostScreen(std::shared_ptr<HostPicture> picture, std::shared_ptr<gpu::Device> device)
        : picture_(std::move(picture)), device_(std::move(device)) {}
    HostScreen(const HostScreen&) = delete;
    HostScreen& operator=(const HostScreen&) = delete;
    ~HostScreen() override { picture_->leaveDevice(); }

    Result<void> resize(VkExtent2D) override { return {}; }
    void setText(std::shared_ptr<const PictureText> text) override { text_ = std::move(text); }
    const std::shared_ptr<const PictureText>& text() const override { return text_; }
    void setMarks(std::shared_ptr<const PictureText> marks) override { marks_ = std::move(marks); }
    const std::shared_ptr<const PictureText>& marks() const override { return marks_; }
    Result<bool> show(const gpu::Image& picture) override {
        MACULA_TRY_VOID(picture_->keep(device_, picture));
        return true;
    }
    Result<bool> showAgain() override { return picture_->isThere(); }
    bool owes() const override { return false; }
    void forget() override { picture_->forget(); }
    Result<bool> showColour(const VkClearColorValue&) override {
        picture_->forget();
        return true;
    }

  private:
    std::shared_ptr<HostPicture> picture_;
    std::shared_ptr<gpu::Device> device_;
    std::shared_ptr<const PictureText> text_;
    std::shared_ptr<const PictureText> marks_;
};

class HostPlace final : public ScreenPlace {
  public:
    explicit HostPlace(std::shared_ptr<HostPicture> picture) : picture_(std::move(picture)) {}
    std::vector<const char*> deviceExtensions() const override { return {}; }
    Result<std::unique_ptr<Screen>> open(const std::shared_ptr<gpu::Device>& device,
                                         VkExtent2D) const override {
        return std::unique_ptr<Screen>(std::make_unique<HostScreen>(picture_, device));
    }

  private:
    std::shared_ptr<HostPicture> picture_;
};

bool hasSize(const gpu::Image& image, const glm::ivec2& sizePx) {
    return image.extent().width == std::uint32_t(sizePx.x) &&
           image.extent().height == std::uint32_t(sizePx.y);
}

gpu::ImageOptions displayed(const char* label, std::uint32_t width, std::uint32_t height) {
    gpu::ImageOptions options;
    options.label = label;
    options.width = width;
    options.height = height;
    options.format = VK_FORMAT_R8G8B8A8_UNORM;
    return options;
}

// No image can be left in the undefined layout, so 0 stands for the general one.
VkImageLayout layoutOf(const LentPicture& target) {
    const auto layout = static_cast<VkImageLayout>(target.layout);
    return layout == VK_IMAGE_LAYOUT_UNDEFINED ? VK_IMAGE_LAYOUT_GENERAL : layout;
}

}  // namespace

Result<void> HostPicture::keep(const std::shared_ptr<gpu::Device>& device, const gpu::Image& picture) {
    MACULA_CHECK(picture.format() == VK_FORMAT_R8G8B8A8_UNORM);
    const VkExtent3D extent = picture.extent();
    if (!kept_ || kept_->device() != device || kept_->extent().width != extent.width ||
        kept_->extent().height != extent.height) {
        kept_.reset();
        MACULA_TRY(kept_, gpu::Image::create(device,
                                             displayed("picture for the host", extent.width, extent.height)));
    }
    // If the copy fails, the picture before must not pass for this one.
    const auto copy = [&]() -> Result<void> {
        MACULA_TRY(gpu::Recorder recorder, gpu::Recorder::create(device, "picture for the host"));
        recorder.copy(picture, *kept_);
        MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
        return {};
    };
    Result<void> copied = copy();
    if (!copied) kept_.reset();
    ++count_;
    return copied;
}

Result<bool> HostPicture::writeTo(std::uint8_t* rgba, std::size_t rowBytes, const glm::ivec2& sizePx) const {
    if (!kept_) return false;
    MACULA_TRY(const std::vector<glm::u8vec4> pixels, gpu::read<glm::u8vec4>(*kept_));
    const auto width = std::size_t(sizePx.x);
    const auto height = std::size_t(sizePx.y);
    const std::size_t keptWidth = kept_->extent().width;
    const std::size_t keptHeight = kept_->extent().height;
    for (std::size_t y = 0; y < height; ++y) {
        const glm::u8vec4* from = pixels.data() + y * keptHeight / height * keptWidth;
        std::uint8_t* to = rgba + y * rowBytes;
        for (std::size_t x = 0; x < width; ++x) {
            const glm::u8vec4& pixel = from[x * keptWidth / width];
            for (int channel = 0; channel < 4; ++channel) *to++ = pixel[channel];
        }
    }
    return true;
}

void HostPicture::leaveDevice() {
    imports_.clear();
    forget();
}

// Copies the picture to a layer of the host's image, scaled to its size.
Result<void> HostPicture::send(const gpu::LentLayer& target, const glm::ivec2& sizePx,
                               const gpu::SubmitOptions& semaphores) const {
    const std::shared_ptr<gpu::Device>& device = kept_->device();
    std::optional<gpu::Image> scaled;
    if (!hasSize(*kept_, sizePx)) {
        const std::size_t rowBytes = 4 * std::size_t(sizePx.x);
        std::vector<std::uint8_t> rgba(rowBytes * std::size_t(sizePx.y));
        MACULA_TRY_VOID(writeTo(rgba.data(), rowBytes, sizePx));
        MACULA_TRY(scaled,
                   gpu::Image::create(device, displayed("scaled picture for the host",
                                                        std::uint32_t(sizePx.x), std::uint32_t(sizePx.y))));
        MACULA_TRY_VOID(gpu::uploadTo(*scaled, std::as_bytes(std::span(rgba))));
    }
    const gpu::Image& from = scaled ? *scaled : *kept_;
    MACULA_TRY(gpu::Recorder recorder, gpu::Recorder::create(device, "picture to the host's image"));
    recorder.copy(from, {{0, 0}, {from.extent().width, from.extent().height}}, target);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit(semaphores));
    return {};
}

Result<bool> HostPicture::copyTo(const LentPicture& target, const glm::ivec2& sizePx) const {
    if (!kept_) return false;
    const gpu::LentLayer layer{
        .image = reinterpret_cast<VkImage>(target.image), .layer = target.layer, .layout = layoutOf(target)};
    MACULA_TRY_VOID(send(layer, sizePx, {}));
    MACULA_TRY_VOID(kept_->device()->waitForAll());
    return true;
}

Result<const gpu::SharedImage*> HostPicture::importOf(
    const std::shared_ptr<const gpu::SharedMemory>& target) {
    const std::shared_ptr<gpu::Device>& device = kept_->device();
    std::erase_if(imports_,
                  [&](const Import& one) { return one.of.expired() || one.image.device() != device; });
    const auto found =
        std::ranges::find_if(imports_, [&](const Import& one) { return one.of.lock() == target; });
    if (found != imports_.end()) return &found->image;
    MACULA_TRY(gpu::SharedImage image, gpu::SharedImage::import(device, *target));
    imports_.push_back({target, std::move(image)});
    return &imports_.back().image;
}

Result<bool> HostPicture::shareTo(const std::shared_ptr<const gpu::SharedMemory>& target) {
    MACULA_CHECK(target != nullptr);
    if (!kept_) return false;
    MACULA_TRY(const gpu::SharedImage* const image, importOf(target));
    const gpu::SharedMemoryHandles& made = target->options();
    MACULA_TRY_VOID(
        send(image->layer(), {std::int32_t(made.width), std::int32_t(made.height)}, image->semaphores()));
    if (!image->signals()) MACULA_TRY_VOID(kept_->device()->waitForAll());
    return true;
}

std::shared_ptr<const ScreenPlace> placeOf(std::shared_ptr<HostPicture> picture) {
    return std::make_shared<const HostPlace>(std::move(picture));
}

}  // namespace macula::live
