#include "xr/eye_copy.h"

#include <fmt/format.h>

#include <cstring>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "base/check.h"
#include "image/image_file.h"
#include "pipeline/gpu/recorder.h"
#include "xr/panel_picture.h"

namespace macula::xr {

namespace {

constexpr const char* kStamp = "Macula - not for primary diagnosis";
constexpr int kMostPictures = 100000;

}  // namespace

Result<void> EyeCopy::begin(const gpu::Image& picture, const EyePicture& eye) {
    MACULA_CHECK(!isUnderWay());
    MACULA_CHECK_EQ(picture.bytes(), picture.texels() * 4);
    if (!buffer_ || buffer_->bytes() != picture.bytes()) {
        buffer_.reset();
        gpu::BufferOptions options;
        options.label = "copy of an eye's picture";
        options.bytes = picture.bytes();
        options.memory = gpu::MemoryKind::readback;
        MACULA_TRY(buffer_, gpu::Buffer::create(device_, options));
    }
    MACULA_TRY(auto recorder, gpu::Recorder::create(device_, "copy of an eye's picture"));
    recorder.copy(picture, *buffer_);
    MACULA_TRY(ticket_, recorder.submit());
    wholePx_ = {int(picture.extent().width), int(picture.extent().height)};
    firstPx_ = eye.firstPx;
    partPx_ = eye.partPx;
    return {};
}

std::optional<EyeView> EyeCopy::take() {
    if (!ticket_ || device_->completedTicket() < *ticket_) return std::nullopt;
    ticket_.reset();
    EyeView view{.sizePx = partPx_, .rgba = {}};
    const std::size_t rowBytes = std::size_t(partPx_.x) * 4;
    view.rgba.resize(rowBytes * std::size_t(partPx_.y));
    const auto* from = reinterpret_cast<const std::uint8_t*>(buffer_->mapped().data());
    for (int y = 0; y < partPx_.y; ++y) {
        const std::size_t texel =
            std::size_t(firstPx_.y + y) * std::size_t(wholePx_.x) + std::size_t(firstPx_.x);
        std::memcpy(&view.rgba[std::size_t(y) * rowBytes], from + 4 * texel, rowBytes);
    }
    for (std::size_t i = 3; i < view.rgba.size(); i += 4) view.rgba[i] = 255;
    return view;
}

EyeView stamped(EyeView view) {
    const int scale = view.sizePx.x >= 640 ? 2 : 1;
    const glm::ivec2 stripPx(view.sizePx.x, (PanelPicture::kLetterPx.y + 4) * scale);
    if (stripPx.y > view.sizePx.y) return view;
    PanelPicture strip(stripPx, PanelColour(0, 0, 0, 255));
    strip.writeInto(kStamp, {0, 0}, stripPx, scale, PanelColour(235, 235, 235, 255));
    const std::size_t bytes = strip.pixels().size() * sizeof(PanelColour);
    std::memcpy(view.rgba.data() + view.rgba.size() - bytes, strip.pixels().data(), bytes);
    return view;
}

Result<std::filesystem::path> writeEyeView(const EyeView& view, const std::filesystem::path& folder) {
    std::error_code error;
    if (!std::filesystem::is_directory(folder, error))
        return Error{ErrorCode::outputNotWritable, Text("The folder for pictures is not there."),
                     folder.string(), Text("Make it, or choose another one.")};
    std::filesystem::path path;
    for (int i = 1; i <= kMostPictures && path.empty(); ++i) {
        std::filesystem::path wanted = folder / fmt::format("macula-headset-{}.png", i);
        if (!std::filesystem::exists(std::filesystem::symlink_status(wanted, error)))
            path = std::move(wanted);
    }
    if (path.empty())
        return Error{ErrorCode::outputNotWritable, Text("The folder for pictures is full of them."),
                     folder.string(), Text("Empty it, or choose another one.")};
    const EyeView said = stamped(view);
    MACULA_TRY_VOID(image::writePng(path, said.sizePx.x, said.sizePx.y, said.rgba,
                                    {{"Software", "Macula"}, {"Description", kStamp}}));
    return path;
}

PictureWriter::~PictureWriter() {
    if (thread_.joinable()) thread_.join();
}

void PictureWriter::start(EyeView view, std::filesystem::path folder, RoomWords words) {
    MACULA_CHECK(!isBusy());
    std::string notWritten = words.say(Text("The picture could not be written."));
    auto write = [this, view = std::move(view), folder = std::move(folder), words = std::move(words),
                  notWritten] {
        std::string sentence = notWritten;
        try {
            const auto written = writeEyeView(view, folder);
            sentence = written ? filled(words.pictureWritten, written->filename().string())
                               : words.say(written.error().message);
        } catch (const std::exception&) {
            sentence = words.say(Text("There is not enough memory for the picture."));
        }
        const std::lock_guard lock(mutex_);
        told_ = std::move(sentence);
    };
    try {
        thread_ = std::thread(std::move(write));
    } catch (const std::system_error&) {
        // No thread could be started. The picture is lost, but the frame continues.
        const std::lock_guard lock(mutex_);
        told_ = std::move(notWritten);
    }
}

std::optional<std::string> PictureWriter::told() {
    std::optional<std::string> told;
    {
        const std::lock_guard lock(mutex_);
        told = std::exchange(told_, std::nullopt);
    }
    if (told && thread_.joinable()) thread_.join();
    return told;
}

}  // namespace macula::xr
