#include "formats/raw_values.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <span>

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kPortion = std::size_t{1} << 20;

// Reads bytes from an offset in a file, and inflates them if they are compressed.
class Source {
  public:
    explicit Source(const ValuesInFile& values)
        : stream_(values.file, std::ios::binary), compressed_(values.compressed) {
        stream_.seekg(static_cast<std::streamoff>(values.offset));
        if (compressed_) {
            input_.resize(kPortion);
            constexpr int kZlibOrGzip = 15 + 32;
            usable_ = inflateInit2(&inflater_, kZlibOrGzip) == Z_OK;
        }
    }
    ~Source() {
        if (compressed_ && usable_) inflateEnd(&inflater_);
    }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;

    // Reads all `length` bytes, or returns false.
    bool read(std::byte* out, std::size_t length) {
        if (compressed_) return usable_ && inflateTo(out, length) == length;
        stream_.read(reinterpret_cast<char*>(out), static_cast<std::streamsize>(length));
        return stream_.gcount() == static_cast<std::streamsize>(length);
    }
    bool skip(std::uint64_t length, const CancelToken& cancel) {
        std::vector<std::byte> none(std::min<std::uint64_t>(length, kPortion));
        for (; length > 0; length -= std::min<std::uint64_t>(length, kPortion)) {
            if (cancel.cancelled() || !read(none.data(), std::min<std::uint64_t>(length, kPortion)))
                return false;
        }
        return true;
    }
    // Call after the last byte: whether the checksum of the stream agrees. Further data are no fault, and
    // neither are stray bytes after the stream: gzip ignores them too.
    bool endsWell() {
        std::byte spare{};
        return !compressed_ || inflateTo(&spare, 1) == 1 || ended_ || (hasEnded_ && inflater_.total_out == 0);
    }

  private:
    std::size_t inflateTo(std::byte* out, std::size_t length) {
        inflater_.next_out = reinterpret_cast<Bytef*>(out);
        inflater_.avail_out = static_cast<uInt>(length);
        while (inflater_.avail_out > 0) {
            if (inflater_.avail_in == 0) {
                stream_.read(reinterpret_cast<char*>(input_.data()),
                             static_cast<std::streamsize>(input_.size()));
                inflater_.next_in = reinterpret_cast<Bytef*>(input_.data());
                inflater_.avail_in = static_cast<uInt>(stream_.gcount());
                if (inflater_.avail_in == 0) break;
            }
            if (ended_) {  // a gzip file may have several members
                if (inflateReset(&inflater_) != Z_OK) break;
                ended_ = false;
            }
            const int status = inflate(&inflater_, Z_NO_FLUSH);
            ended_ = status == Z_STREAM_END;
            hasEnded_ = hasEnded_ || ended_;
            if (status != Z_OK && !ended_) break;
        }
        return length - inflater_.avail_out;
    }

    std::ifstream stream_;
    bool compressed_;
    bool usable_ = true;
    bool ended_ = false;
    bool hasEnded_ = false;
    std::vector<std::byte> input_;
    z_stream inflater_{};
};

// Reads values of the volume that is wanted: all, or every so manieth where volumes alternate.
bool readPart(Source& source, const ValuesInFile& values, std::size_t width, std::span<std::byte> out) {
    if (values.interleaved <= 1) return source.read(out.data(), out.size());
    const std::size_t group = width * values.interleaved;  // of one voxel
    const std::size_t most = std::max<std::size_t>(kPortion / group, 1);
    std::vector<std::byte> groups;
    for (std::size_t voxel = 0, voxels = out.size() / width; voxel < voxels;) {
        const std::size_t count = std::min(most, voxels - voxel);
        groups.resize(count * group);
        if (!source.read(groups.data(), groups.size())) return false;
        for (std::size_t n = 0; n < count; ++n, ++voxel)
            std::copy_n(groups.begin() + std::ptrdiff_t(n * group + values.part * width), width,
                        out.begin() + std::ptrdiff_t(voxel * width));
    }
    return true;
}

}  // namespace

Error cutOff() {
    return {ErrorCode::inputNotUsable,
            Text("The file is cut off or damaged."),
            {},
            Text("Get the file again from where it came.")};
}

ValuesInFile valuesOfVolume(ValuesInFile values, const RawImageLayout& layout, std::size_t volume) {
    if (values.interleaved > 1) {
        values.part = volume - 1;
    } else {
        (values.compressed ? values.skip : values.offset) += (volume - 1) * layout.bytes();
    }
    return values;
}

Result<void> checkExtent(const RawImageLayout& layout, const ValuesInFile& values) {
    std::error_code error;
    const std::uint64_t bytes = fs::file_size(values.file, error);
    if (error || !std::ifstream(values.file, std::ios::binary)) {
        return Error{ErrorCode::inputNotUsable, Text("The file cannot be read."), values.file.string(),
                     Text("Check the path and its permissions.")};
    }
    return checkLayout(layout, (bytes - std::min(bytes, values.offset)) / values.interleaved,
                       values.compressed);
}

Result<RawImage> readValues(RawImageLayout layout, const ValuesInFile& values, Progress& progress) {
    MACULA_TRY_VOID(checkExtent(layout, values));
    RawImage image{std::move(layout), {}};
    const auto bytes = static_cast<std::size_t>(image.bytes());
    progress.beginStage(Text("Reading"), (bytes + kPortion - 1) / kPortion);
    const std::size_t width = bytesOf(image.type);
    Source source(values);
    const auto cancelled = [] { return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}}; };
    if (!source.skip(values.skip, progress.token())) return progress.cancelled() ? cancelled() : cutOff();
    if (!values.compressed) image.data.reserve(bytes);
    for (std::size_t at = 0; at < bytes; at += kPortion) {
        const std::size_t length = std::min(kPortion, bytes - at);
        image.data.resize(at + length);
        if (!readPart(source, values, width, {image.data.data() + at, length})) return cutOff();
        progress.advance();
        if (progress.cancelled()) return cancelled();
    }
    if (!source.endsWell()) return cutOff();
    if (values.bigEndian && width > 1) {
        for (auto value = image.data.begin(); value != image.data.end();
             value += static_cast<std::ptrdiff_t>(width))
            std::reverse(value, value + static_cast<std::ptrdiff_t>(width));
    }
    return image;
}

}  // namespace macula::formats
