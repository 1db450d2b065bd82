#include "live/frame/window_screen.h"

#include <cstdlib>
#include <utility>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"

namespace macula::live {

namespace {

// Long enough for any window system, short enough that a stuck one does not hold up the render thread.
constexpr std::uint64_t kAcquireTimeoutNs = 100'000'000;
constexpr int kResizeAttempts = 3;

// Some window systems count in other units than pixels: then the two sizes may differ by rounding.
bool isOf(const PictureText& text, VkExtent2D target) {
    constexpr int kRoundingPx = 2;
    if (text.of.width == 0) return true;
    return std::abs(int(text.of.width) - int(target.width)) <= kRoundingPx &&
           std::abs(int(text.of.height) - int(target.height)) <= kRoundingPx;
}

}  // namespace

Result<std::unique_ptr<Screen>> WindowPlace::open(const std::shared_ptr<gpu::Device>& device,
                                                  VkExtent2D extent) const {
    // Mailbox: tracing must not wait for the display.
    MACULA_TRY(
        gpu::Swapchain swapchain,
        gpu::Swapchain::create(device, surface_, {.extent = extent, .mode = gpu::PresentMode::mailbox}));
    return std::unique_ptr<Screen>(std::make_unique<WindowScreen>(device, std::move(swapchain), extent));
}

WindowScreen::WindowScreen(std::shared_ptr<gpu::Device> device, gpu::Swapchain swapchain, VkExtent2D wanted)
    : device_(std::move(device)), swapchain_(std::move(swapchain)), wanted_(wanted) {}

Result<void> WindowScreen::resize(VkExtent2D extent) {
    wanted_ = extent;
    return swapchain_.resize(extent);
}

void WindowScreen::setText(std::shared_ptr<const PictureText> text) {
    if (text != text_.text) text_ = {.text = std::move(text), .image = {}};
}

void WindowScreen::setMarks(std::shared_ptr<const PictureText> marks) {
    if (marks != marks_.text) marks_ = {.text = std::move(marks), .image = {}};
}

Result<void> WindowScreen::prepare(Overlay& overlay) {
    if (!overlay.text || overlay.image || isColour_) return {};
    const PictureText& text = *overlay.text;
    MACULA_TRY(gpu::Image image, gpu::Image::create(device_, {.label = "text over the picture",
                                                              .width = text.size.width,
                                                              .height = text.size.height,
                                                              .format = VK_FORMAT_R8G8B8A8_UNORM}));
    MACULA_TRY_VOID(gpu::uploadTo(image, std::span<const std::byte>(text.rgba)));
    overlay.image = std::move(image);
    return {};
}

// The overlays that fit a window of that size.
std::vector<gpu::BlitOverlay> WindowScreen::overlaysFor(VkExtent2D target) const {
    std::vector<gpu::BlitOverlay> overlays;
    for (const Overlay* overlay : {&text_, &marks_}) {
        if (isColour_ || !overlay->image || !isOf(*overlay->text, target)) continue;
        overlays.push_back(
            {.image = &*overlay->image, .parts = overlay->text->boxes, .places = overlay->text->places});
    }
    return overlays;
}

Result<bool> WindowScreen::show(const gpu::Image& picture) {
    isColour_ = false;
    MACULA_TRY_VOID(keep(picture));
    return showAgain();
}

Result<void> WindowScreen::keep(const gpu::Image& picture) {
    const VkExtent3D extent = picture.extent();
    const bool fits = kept_ && kept_->extent().width == extent.width &&
                      kept_->extent().height == extent.height && kept_->format() == picture.format();
    if (!fits) {
        keptIsValid_ = false;
        MACULA_TRY(gpu::Image image, gpu::Image::create(device_, {.label = "picture shown",
                                                                  .width = extent.width,
                                                                  .height = extent.height,
                                                                  .format = picture.format()}));
        kept_ = std::move(image);
    }
    MACULA_TRY(gpu::Recorder recorder, gpu::Recorder::create(device_, "keep picture"));
    recorder.copy(picture, *kept_);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    keptIsValid_ = true;
    return {};
}

Result<bool> WindowScreen::showAgain() {
    if (!keptIsValid_) return false;
    owes_ = true;
    MACULA_TRY_VOID(prepare(text_));
    MACULA_TRY_VOID(prepare(marks_));
    for (int attempt = 0; attempt < kResizeAttempts; ++attempt) {
        MACULA_TRY(const gpu::Swapchain::Frame frame, swapchain_.acquire(kAcquireTimeoutNs));
        if (frame.status == gpu::Swapchain::Status::outOfDate) {
            MACULA_TRY_VOID(swapchain_.resize(wanted_));
            continue;
        }
        owes_ = frame.status != gpu::Swapchain::Status::hidden;
        if (!frame.usable()) return false;
        const std::vector<gpu::BlitOverlay> overlays = overlaysFor(frame.extent);
        MACULA_TRY(gpu::Recorder recorder, gpu::Recorder::create(device_, "present"));
        // A picture of the window's size is not scaled; on a CPU device nearest filtering is then faster.
        const VkExtent3D size = kept_->extent();
        const bool isSameSize = size.width == frame.extent.width && size.height == frame.extent.height;
        recorder.blit(*kept_, frame.target(), isSameSize ? VK_FILTER_NEAREST : VK_FILTER_LINEAR, overlays);
        MACULA_TRY(const gpu::Ticket ticket,
                   recorder.submit({.wait = frame.available, .signal = frame.rendered}));
        MACULA_TRY(const gpu::Swapchain::Status status, swapchain_.present(frame, ticket));
        owes_ = status == gpu::Swapchain::Status::outOfDate;
        if (status == gpu::Swapchain::Status::ready) return true;
        // The window changed its size meanwhile. The input with the new size is on its way; until then this
        // picture, scaled, is better than none.
        MACULA_TRY_VOID(swapchain_.resize(wanted_));
        if (status == gpu::Swapchain::Status::suboptimal) return true;
    }
    return false;
}

Result<bool> WindowScreen::showColour(const VkClearColorValue& colour) {
    MACULA_TRY(const gpu::Image image,
               gpu::Image::create(device_, {.label = "empty picture", .format = VK_FORMAT_R8G8B8A8_UNORM}));
    MACULA_TRY(gpu::Recorder recorder, gpu::Recorder::create(device_, "empty picture"));
    recorder.clear(image, colour);
    MACULA_TRY([[maybe_unused]] const gpu::Ticket ticket, recorder.submit());
    isColour_ = true;
    MACULA_TRY_VOID(keep(image));
    return showAgain();
}

}  // namespace macula::live
