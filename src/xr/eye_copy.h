// Copies the left eye's picture, for the mirror in a window, and for pictures that the wearer takes. Never
// blocks: a copy arrives some frames later.
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
    // `picture` is the eye's whole picture.
    Result<void> begin(const gpu::Image& picture, const EyePicture& eye);
    // Returns the copy once, when it has arrived.
    std::optional<EyeView> take();

  private:
    std::shared_ptr<gpu::Device> device_;
    std::optional<gpu::Buffer> buffer_;
    std::optional<gpu::Ticket> ticket_;
    glm::ivec2 wholePx_{0};
    glm::ivec2 firstPx_{0};
    glm::ivec2 partPx_{0};
};

// The picture with "Not for primary diagnosis" stamped into it.
EyeView stamped(EyeView view);

// Writes a PNG into the folder under a free name: "macula-headset-1.png". Picture, file and name do not
// identify the patient, and the picture says that it is not for primary diagnosis. Returns the path.
Result<std::filesystem::path> writeEyeView(const EyeView& view, const std::filesystem::path& folder);

// Writes pictures on a thread of its own.
class PictureWriter {
  public:
    PictureWriter() = default;
    PictureWriter(const PictureWriter&) = delete;
    ~PictureWriter();  // waits for a running write

    bool isBusy() const { return thread_.joinable(); }
    // Call it only while isBusy() is false.
    void start(EyeView view, std::filesystem::path folder, RoomWords words);
    // Returns, once after each write or failure, a sentence for the wearer in `words`.
    std::optional<std::string> told();

  private:
    std::thread thread_;
    std::mutex mutex_;
    std::optional<std::string> told_;
};

}  // namespace macula::xr
