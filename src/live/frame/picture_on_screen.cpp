#include "live/frame/picture_on_screen.h"

#include <utility>

#include "base/log.h"
#include "base/srgb.h"

namespace macula::live {

namespace {

constexpr std::chrono::milliseconds kRateWindow{2000};

}  // namespace

// Text and marks name the phase, so those of another one must not stand over the kept picture.
bool PictureOnScreen::keepsPhaseOf(const FrameInput& input) const {
    return !kept_ || keptOf_.lock() == input.volume;
}

bool PictureOnScreen::hasOtherText(const FrameInput& input) const {
    return screen_ && screen_->text() != input.text && keepsPhaseOf(input);
}

// Whether the input's marks fit the picture on screen, but are not there: they were just hidden or shown.
bool PictureOnScreen::hasOtherMarks(const FrameInput& input) const {
    return screen_ && keepsPhaseOf(input) && kept_ == View{input.camera, input.width, input.height} &&
           screen_->marks() != input.marks;
}

bool PictureOnScreen::isRight(const FrameInput& input) const {
    return screen_ && exposures_ == input.exposures && !hasOtherText(input) && !hasOtherMarks(input) &&
           !duty_.isForeign() && !screen_->owes();
}

Result<void> PictureOnScreen::ensure(const FrameInput& input) {
    const VkExtent2D window{std::uint32_t(input.width), std::uint32_t(input.height)};
    if (!screen_) {
        MACULA_TRY(screen_, input.place->open(device_.device(), window));
        kept_.reset();
        duty_.beginAnew();
    } else if (window_.width != window.width || window_.height != window.height) {
        MACULA_TRY_VOID(screen_->resize(window));
    }
    window_ = window;
    // A kept picture belongs to the study of the input: forgetPicture() has dropped that of another study.
    const bool isOtherText = hasOtherText(input);
    const bool isOtherMarks = hasOtherMarks(input);
    if (exposures_ != input.exposures || isOtherText || isOtherMarks || screen_->owes()) {
        exposures_ = input.exposures;
        if (isOtherText) screen_->setText(input.text);
        if (isOtherMarks) screen_->setMarks(input.marks);
        MACULA_TRY(const bool shown, screen_->showAgain());
        if (shown) {
            if (duty_.isForeign()) reports_.tell(PictureRemoved{});
            duty_.showedOurs();
            if (unreported_) reports_.tell(*std::exchange(unreported_, std::nullopt));
        }
    }
    return {};
}

void PictureOnScreen::release() {
    if (const Result<void> closed = close(); !closed) log::warning("{}", closed.error().message.english());
}

Result<void> PictureOnScreen::close() {
    if (!screen_) return {};
    std::unique_ptr<Screen> screen = std::exchange(screen_, nullptr);
    gpu::Device& device = *device_.device();
    if (device.lost()) return {};  // dropping it is all that is left to do
    MACULA_TRY_VOID(device.waitForAll());
    screen.reset();
    // The reset has only queued the destruction, and a surface must outlive its swapchain.
    MACULA_TRY_VOID(device.waitForAll());
    device.destroyUnused();
    return {};
}

Result<void> PictureOnScreen::clear(const glm::vec3& background) {
    forgetPicture();
    shown_.clear();
    const glm::vec3& b = background;
    const VkClearColorValue colour{{encodedSrgb(b.r), encodedSrgb(b.g), encodedSrgb(b.b), 1.0f}};
    MACULA_TRY_VOID(screen_->showColour(colour));
    if (screen_->owes()) {
        duty_.owesClearing();
    } else {  // cleared, or hidden
        duty_.showedOurs();
        reports_.tell(PictureRemoved{});
    }
    return {};
}

void PictureOnScreen::forgetPicture() {
    if (screen_) screen_->forget();
    kept_.reset();
    unreported_.reset();
}

void PictureOnScreen::forgetWindow() {
    window_ = {};
    exposures_ = 0;
}

Result<PictureOnScreen::Put> PictureOnScreen::put(const gpu::Image& picture, const FrameInput& input,
                                                  OnScreen kind) {
    screen_->setText(input.text);
    screen_->setMarks(input.marks);
    kept_ = {input.camera, input.width, input.height};
    keptOf_ = input.volume;
    MACULA_TRY(const bool visible, screen_->show(picture));
    const Clock::time_point now = Clock::now();
    // The frame rate counts only pictures of the kind that is shown now.
    if (std::exchange(kind_, kind) != kind) shown_.clear();
    if (visible) {
        duty_.showedOurs();
        shown_.push_back(now);
    }
    while (!shown_.empty() && now - shown_.front() > kRateWindow) shown_.pop_front();
    return Put{visible, now, framesPerSecond()};
}

void PictureOnScreen::report(FrameShown frame, bool isVisible) {
    // A picture that could not be shown now is kept by the screen, and reported once it is visible.
    unreported_ = isVisible ? std::nullopt : std::optional(frame);
    if (isVisible) reports_.tell(std::move(frame));
}

double PictureOnScreen::framesPerSecond() const {
    if (shown_.size() < 2) return 0.0;
    const double spanMs = std::chrono::duration<double, std::milli>(shown_.back() - shown_.front()).count();
    return spanMs > 0.0 ? 1000.0 * double(shown_.size() - 1) / spanMs : 0.0;
}

}  // namespace macula::live
