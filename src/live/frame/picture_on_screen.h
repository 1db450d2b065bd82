// The picture on a renderer's screen, with the report of it.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>

#include "base/camera.h"
#include "base/result.h"
#include "live/frame/frame_input.h"
#include "live/frame/render_device.h"
#include "live/frame/render_duty.h"
#include "live/frame/render_events.h"
#include "live/frame/render_reports.h"
#include "live/frame/screen.h"
#include "pipeline/gpu/resources.h"

namespace macula::live {

// Opens the screen on the place of an input, keeps it up to date, and closes it. Reports to RenderDuty
// whether the screen shows what may not stay (isForeign).
//
// Used by the render thread alone. The device must be there while the screen is open: release() before it is
// dropped.
class PictureOnScreen {
  public:
    using Clock = std::chrono::steady_clock;

    PictureOnScreen(const RenderDevice& device, RenderDuty& duty, RenderReports& reports)
        : device_(device), duty_(duty), reports_(reports) {}

    bool isOpen() const { return screen_ != nullptr; }
    // Whether the screen is open and, apart from the size of the window, ensure() has nothing to do.
    bool isRight(const FrameInput& input) const;
    // Opens the screen or fits it to the window, and shows the kept picture again where needed.
    Result<void> ensure(const FrameInput& input);
    // Closes the screen: afterwards nothing refers to its place.
    void release();

    // Whether clear() must be called, because the screen shows another study or the remains of a failure. If
    // it still owes a picture, that is the empty one of an earlier clear().
    bool mustBeCleared() const { return duty_.isForeign() && !screen_->owes(); }
    Result<void> clear(const glm::vec3& background);
    // Drops the kept picture and its report. What is visible stays until the screen is cleared.
    void forgetPicture();
    // On a new device: the size of the window and its exposures are unknown.
    void forgetWindow();

    struct Put {
        bool isVisible = false;
        Clock::time_point at{};
        double framesPerSecond = 0.0;  // rate of recent pictures of this kind; 0 if there was only one
    };
    // Shows the picture with the marks of the input. The caller reports it with report().
    Result<Put> put(const gpu::Image& picture, const FrameInput& input, OnScreen kind);
    // Reports the picture that was put: now, or as soon as it is visible.
    void report(FrameShown frame, bool isVisible);

  private:
    // The view of the picture that the screen keeps.
    struct View {
        Camera camera;
        int width;
        int height;

        bool operator==(const View&) const = default;
    };

    Result<void> close();
    bool keepsPhaseOf(const FrameInput& input) const;
    bool hasOtherText(const FrameInput& input) const;
    bool hasOtherMarks(const FrameInput& input) const;
    double framesPerSecond() const;

    const RenderDevice& device_;
    RenderDuty& duty_;
    RenderReports& reports_;
    std::unique_ptr<Screen> screen_;
    VkExtent2D window_{};
    std::uint64_t exposures_ = 0;
    std::optional<View> kept_;
    std::weak_ptr<const Volume> keptOf_;    // the volume of the kept picture
    std::optional<FrameShown> unreported_;  // for the kept picture, until it is visible
    std::deque<Clock::time_point> shown_;   // recent times at which kind_ was shown
    OnScreen kind_ = OnScreen::nothing;
};

}  // namespace macula::live
