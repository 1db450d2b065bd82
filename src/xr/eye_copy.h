// What the left eye sees, copied for others: the mirror of a window, and pictures that are taken. Waits for
// nothing: a copy is there some frames later.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/result.h"
#include "pipeline/gpu/device.h"
#include "pipeline/gpu/resources.h"
#include "xr/eyes.h"
#include "xr/room_state.h"
#include "xr/room_words.h"

namespace macula::xr {

// Used by one thread at a time, the one that uses the device.
class EyeCopy {
  public:
    explicit EyeCopy(std::shared_ptr<gpu::Device> device) : device_(std::move(device)) {}

    bool isUnderWay() const { return ticket_.has_value(); }
    // `picture` is that of the eye, in whole.
    Result<void> begin(const gpu::Image& picture, const EyePicture& eye);
    // Once, when it is there.
    std::optional<EyeView> take();

  private:
    std::shared_ptr<gpu::Device> device_;
    std::optional<gpu::Buffer> buffer_;
    std::optional<gpu::Ticket> ticket_;
    glm::ivec2 wholePx_{0};
    glm::ivec2 firstPx_{0};
    glm::ivec2 partPx_{0};
};

// With "Not for primary diagnosis" in it.
EyeView stamped(EyeView view);

// Writes a PNG into the folder under a name that is not taken: "macula-headset-1.png". It names no patient,
// in the picture, the file or its name, and says that it is not for primary diagnosis. The path.
Result<std::filesystem::path> writeEyeView(const EyeView& view, const std::filesystem::path& folder);

// Writes beside the frames.
class PictureWriter {
  public:
    PictureWriter() = default;
    PictureWriter(const PictureWriter&) = delete;
    ~PictureWriter();  // waits for what is under way

    bool isBusy() const { return thread_.joinable(); }
    // After isBusy was false.
    void start(EyeView view, std::filesystem::path folder, RoomWords words);
    // Once, when it is written or was not: a sentence for who wears the headset, in these words.
    std::optional<std::string> told();

  private:
    std::thread thread_;
    std::mutex mutex_;
    std::optional<std::string> told_;
};

}  // namespace macula::xr
