#include "pipeline/splat/files/model_file.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "base/check.h"
#include "pipeline/splat/files/chunk_file.h"
#include "pipeline/splat/files/glb.h"
#include "pipeline/splat/files/ply.h"
#include "pipeline/splat/files/spz.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::splat {

namespace {

namespace fs = std::filesystem;

// 10 million splats of degree 3 take 650 MB unpacked.
constexpr std::uint64_t kMostSpzBytes = std::uint64_t{1} << 30;

// "a, b or c".
Text listed(std::vector<std::string_view> names) {
    const std::string_view last = names.back();
    names.pop_back();
    return Text("{} or {}", fmt::format("{}", fmt::join(names, ", ")), last);
}

Text modelNames() {
    std::vector<std::string_view> names;
    for (const ModelFormat& format : kModelFormats) names.push_back(format.name);
    return listed(std::move(names));
}

Error unreadable(const fs::path& path) {
    return {ErrorCode::inputNotUsable, Text("The model cannot be read."), path.string(),
            Text("Check the path and its permissions.")};
}

Error tooLarge(const fs::path& path, std::string_view format) {
    return {ErrorCode::inputNotUsable, Text("The file is larger than any {} model.", format), path.string(),
            Text("Check that it is the file you meant.")};
}

Result<std::vector<std::byte>> bytesOf(std::istream& stream, std::uint64_t size) {
    std::vector<std::byte> bytes(size);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (static_cast<std::uint64_t>(stream.gcount()) != size) return unreadable({});
    return bytes;
}

Result<ModelFile> readByContent(const fs::path& path, BadSplats bad) {
    std::error_code error;
    if (fs::is_directory(path, error))
        return Error{ErrorCode::inputNotUsable, Text("That is a folder, not a model."), path.string(),
                     Text("Choose a {} file.", modelExtensions(true))};
    if (!fs::is_regular_file(path, error))
        return Error{ErrorCode::inputNotUsable, Text("The model does not exist."), path.string(),
                     Text("Check the path.")};
    const std::uint64_t size = fs::file_size(path, error);
    std::ifstream stream(path, std::ios::binary);
    if (error || !stream) return unreadable(path);
    std::array<char, kChunkFileMagic.size()> start{};
    stream.read(start.data(), start.size());
    const std::string_view begin(start.data(), static_cast<std::size_t>(stream.gcount()));
    stream.clear();
    stream.seekg(0);
    if (begin.starts_with("ply")) return readPly(stream, size, bad);
    if (looksLikeTraining(begin)) return readTrainedModel(stream, size, bad);
    if (looksLikeGlb(begin)) {
        if (size > kMostGlbBytes) return tooLarge(path, "glTF");
        MACULA_TRY(const std::vector<std::byte> bytes, bytesOf(stream, size));
        return decodeGlb(bytes, bad);
    }
    if (!looksLikeSpz(begin.substr(0, 4)))
        return Error{ErrorCode::inputNotUsable, Text("The file is no {} model.", modelNames()), path.string(),
                     Text("Choose a model of Gaussians, or convert it to PLY.")};
    if (size > kMostSpzBytes) return tooLarge(path, "SPZ");
    MACULA_TRY(const std::vector<std::byte> bytes, bytesOf(stream, size));
    return decodeSpz(bytes, bad);
}

Result<std::size_t> writeTo(std::ostream& stream, const Splats& splats, ModelKind kind) {
    std::size_t clamped = 0;
    switch (kind) {
        case ModelKind::ply:
            MACULA_TRY_VOID(writePly(stream, splats));
            break;
        case ModelKind::spz: {
            MACULA_TRY(const SpzBytes file, encodeSpz(splats));
            clamped = file.clamped;
            stream.write(reinterpret_cast<const char*>(file.bytes.data()),
                         static_cast<std::streamsize>(file.bytes.size()));
            break;
        }
        case ModelKind::glb: {
            MACULA_TRY(clamped, writeGlb(stream, splats));
            break;
        }
        case ModelKind::training:
            MACULA_CHECK(false);  // only writeTraining writes this format
    }
    stream.flush();
    if (!stream)
        return Error{ErrorCode::outputNotWritable,
                     Text("The model could not be written."),
                     {},
                     Text("Check free space and permissions.")};
    return clamped;
}

}  // namespace

const ModelFormat* modelFormatOf(const fs::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = std::ranges::find(kModelFormats, extension, &ModelFormat::extension);
    return found == kModelFormats.end() ? nullptr : &*found;
}

Text modelExtensions(bool withTraining) {
    std::vector<std::string_view> extensions;
    for (const ModelFormat& format : kModelFormats) {
        if (withTraining || !format.keepsTraining()) extensions.push_back(format.extension);
    }
    return listed(std::move(extensions));
}

Result<ModelFile> readModel(const fs::path& path, BadSplats bad) {
    Result<ModelFile> model = readByContent(path, bad);
    if (model.ok()) return model;
    Error error = model.error();
    error.where = path.string();
    return error;
}

Result<std::size_t> writeModel(const fs::path& path, const Splats& splats) {
    const ModelFormat* format = modelFormatOf(path);
    if (format == nullptr || format->keepsTraining())
        return Error{ErrorCode::usage, Text("Models are written as {}.", modelExtensions(false)),
                     path.string(), Text("Give the file one of these extensions.")};
    std::size_t clamped = 0;
    MACULA_TRY_VOID(writeAtomically(path, [&](const fs::path& temporary) -> Result<void> {
        std::ofstream stream(temporary, std::ios::binary);
        MACULA_TRY(clamped, writeTo(stream, splats, format->kind));
        return {};
    }));
    return clamped;
}

Result<ModelFile> finishModel(Splats splats, BadSplats bad) {
    ModelFile model{std::move(splats), {}};
    if (bad != BadSplats::refuse) {
        MACULA_TRY(model.repaired, repair(model.splats));
    } else {
        MACULA_TRY_VOID(model.splats.validate());
    }
    if (model.splats.size() == 0 && bad != BadSplats::repairOrNone)
        return Error{ErrorCode::inputNotUsable,
                     model.repaired.dropped > 0 ? Text("None of the model's splats can be used.")
                                                : Text("The model holds no splats."),
                     {},
                     Text("Export or train it again.")};
    return model;
}

}  // namespace macula::splat
