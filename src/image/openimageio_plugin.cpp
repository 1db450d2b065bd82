// The only file that uses OpenImageIO, built as a plug-in (picture_files.h). Exceptions of OpenImageIO do not
// leave it.
#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <new>

#include "base/atomic_file.h"
#include "image/picture_files.h"

namespace macula::image::openimageio {

namespace fs = std::filesystem;

namespace {

Error notUsable(const fs::path& path, Text message, Text hint) {
    return {ErrorCode::inputNotUsable, std::move(message), path.string(), std::move(hint)};
}

Error damaged(const fs::path& path) {
    return notUsable(path, Text("The picture file is damaged or incomplete."),
                     Text("Export or download it again."));
}

Error notWritable(const fs::path& path) {
    return {ErrorCode::outputNotWritable, Text("The picture could not be written."), path.string(),
            Text("Check free space and permissions of the folder.")};
}

// Accepts only the formats that we mean to read: OpenImageIO would try all of its own, DICOM and video among
// them.
Result<std::string> formatOf(const fs::path& path) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        return notUsable(path, Text("The picture file does not exist."), Text("Check the path."));
    }
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
        return notUsable(path, Text("The picture file could not be opened."), Text("Check its permissions."));
    std::array<char, 8> bytes{};
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    const std::string_view magic(bytes.data(), static_cast<std::size_t>(stream.gcount()));
    if (magic.starts_with("#?")) return std::string("hdr");
    if (magic.starts_with("\x76\x2f\x31\x01")) return std::string("openexr");
    if (magic.starts_with("\x89PNG\r\n\x1a\n")) return std::string("png");
    return notUsable(path, Text("The file is no Radiance HDR, OpenEXR or PNG picture."),
                     Text("Give a file of one of these formats; renaming does not convert it."));
}

// Runs an adapter function and turns any exception into an error.
template <class Function>
auto guarded(const Error& otherwise, Function&& function) -> decltype(function()) {
    try {
        return function();
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory, Text("There is not enough memory for the picture."),
                     otherwise.where, Text("Close other programs, or use a smaller picture.")};
    } catch (const std::exception&) {
        return otherwise;
    }
}

Result<std::unique_ptr<OIIO::ImageInput>> open(const fs::path& path, OIIO::ImageSpec& spec) {
    MACULA_TRY(const std::string format, formatOf(path));
    auto input = OIIO::ImageInput::create(format);
    if (!input) {
        OIIO::geterror();  // clears the pending message, which would be printed at exit
        return notUsable(path, Text("This build cannot read {} pictures.", format),
                         Text("Give a picture of another format."));
    }
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(path.string(), spec, config)) return damaged(path);
    if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1 || spec.depth > 1 || spec.deep) {
        return notUsable(path, Text("The file is no flat picture."),
                         Text("Give a picture with one layer of pixels."));
    }
    if (spec.width > kMaxEdge || spec.height > kMaxEdge || spec.nchannels > 64) {
        return notUsable(path,
                         Text("The picture is too large: {} by {} pixels, {} channels.", spec.width,
                              spec.height, spec.nchannels),
                         Text("Scale it to at most {} pixels on each side.", kMaxEdge));
    }
    if (spec.image_pixels() * static_cast<std::uint64_t>(spec.nchannels) * sizeof(float) > kMaxBytes) {
        return notUsable(path, Text("The picture has too many pixels and channels."),
                         Text("Scale it down, or leave channels out."));
    }
    return input;
}

struct CloseFile {
    void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};

// Checks the stream itself, because OpenImageIO's PNG writer reports success for every write.
Result<void> write(const fs::path& path, const OIIO::ImageSpec& spec, OIIO::TypeDesc type,
                   const void* pixels) {
    return writeAtomically(path, [&](const fs::path& temporary) {
        return guarded(notWritable(path), [&]() -> Result<void> {
            const char* format = type == OIIO::TypeDesc::UINT8 ? "png" : "openexr";
            const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(temporary.c_str(), "wbe"));
            auto output = OIIO::ImageOutput::create(format);
            if (!file || !output) {
                OIIO::geterror();
                return notWritable(path);
            }
            OIIO::Filesystem::IOFile stream(file.get(), OIIO::Filesystem::IOProxy::Write);
            OIIO::Filesystem::IOProxy* proxy = &stream;
            OIIO::ImageSpec ofStream = spec;
            ofStream.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
            const bool written =
                output->open(temporary.string(), ofStream) && output->write_image(type, pixels);
            if (!output->close() || !written) return notWritable(path);
            if (std::fflush(file.get()) != 0 || std::ferror(file.get()) != 0) return notWritable(path);
            return {};
        });
    });
}

void setMetadata(OIIO::ImageSpec& spec, const Metadata& metadata) {
    for (const auto& [key, value] : metadata) spec.attribute(key, value);
}

}  // namespace

Result<Image> readImage(const fs::path& path) {
    return guarded(damaged(path), [&]() -> Result<Image> {
        OIIO::ImageSpec spec;
        MACULA_TRY(const auto input, open(path, spec));
        Image image{spec.width,
                    spec.height,
                    spec.nchannels,
                    input->format_name() == std::string_view("png") ? Encoding::display : Encoding::linear,
                    {}};
        image.pixels.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
        if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.pixels.data())) {
            return damaged(path);
        }
        return image;
    });
}

Result<void> writePng(const fs::path& path, int width, int height, std::span<const std::uint8_t> rgba,
                      const Metadata& metadata) {
    MACULA_CHECK_EQ(rgba.size(), static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
    OIIO::ImageSpec spec(width, height, 4, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);  // else OpenImageIO divides the colours by alpha
    setMetadata(spec, metadata);
    return write(path, spec, OIIO::TypeDesc::UINT8, rgba.data());
}

Result<void> writeExr(const fs::path& path, int width, int height, std::span<const float> rgba,
                      std::span<const float> depthMm, const Metadata& metadata) {
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    MACULA_CHECK_EQ(rgba.size(), count * 4);
    const bool hasDepth = !depthMm.empty();
    if (hasDepth) MACULA_CHECK_EQ(depthMm.size(), count);
    OIIO::ImageSpec spec(width, height, hasDepth ? 5 : 4, OIIO::TypeDesc::FLOAT);
    spec.channelnames = {"R", "G", "B", "A"};
    spec.alpha_channel = 3;
    if (hasDepth) {
        spec.channelnames.emplace_back("Z");
        spec.z_channel = 4;
    }
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("compression", "zip");
    setMetadata(spec, metadata);
    if (!hasDepth) return write(path, spec, OIIO::TypeDesc::FLOAT, rgba.data());

    std::vector<float> interleaved(count * 5);
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t c = 0; c < 4; ++c) interleaved[i * 5 + c] = rgba[i * 4 + c];
        interleaved[i * 5 + 4] = depthMm[i];
    }
    return write(path, spec, OIIO::TypeDesc::FLOAT, interleaved.data());
}

Result<Metadata> readMetadata(const fs::path& path, std::span<const std::string> keys) {
    return guarded(damaged(path), [&]() -> Result<Metadata> {
        OIIO::ImageSpec spec;
        MACULA_TRY(const auto input, open(path, spec));
        Metadata metadata;
        for (const std::string& key : keys) {
            const std::string value(spec.get_string_attribute(key));
            if (!value.empty()) metadata.emplace_back(key, value);
        }
        return metadata;
    });
}

}  // namespace macula::image::openimageio

extern "C" const macula::image::PictureFiles* maculaPictureFiles() {
    static constexpr macula::image::PictureFiles kFiles{
        .readImage = &macula::image::openimageio::readImage,
        .writePng = &macula::image::openimageio::writePng,
        .writeExr = &macula::image::openimageio::writeExr,
        .readMetadata = &macula::image::openimageio::readMetadata,
    };
    return &kFiles;
}
