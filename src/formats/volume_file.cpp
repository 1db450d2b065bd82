#include "formats/volume_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "base/available_memory.h"
#include "base/draft.h"
#include "base/exceptions.h"
#include "base/parsing.h"
#include "formats/itk_image_file.h"
#include "formats/nifti.h"
#include "formats/text_header.h"

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

enum class Format { nifti, nrrd, metaImage };

struct Ending {
    std::string_view text;
    Format format;
    bool detached;  // the values lie in a second file
    bool isWritten = true;
};
constexpr std::array<Ending, 7> kEndings{{{".nii.gz", Format::nifti, false},
                                          {".nii", Format::nifti, false},
                                          {".nrrd", Format::nrrd, false},
                                          {".nhdr", Format::nrrd, true},
                                          {".mha", Format::metaImage, false},
                                          {".mhd", Format::metaImage, true},
                                          {".hdr", Format::nifti, true, false}}};

const Ending* endingOf(const fs::path& path) {
    const std::string name = lowerCase(path.filename().string());
    for (const Ending& ending : kEndings) {
        if (name.size() > ending.text.size() && name.ends_with(ending.text)) return &ending;
    }
    return nullptr;
}

Result<Ending> knownEndingOf(const fs::path& path) {
    if (const Ending* ending = endingOf(path)) return *ending;
    return Error{ErrorCode::usage, Text("The ending of the name is that of no volume file."), path.string(),
                 Text("Known are {}.", volumeFileEndings())};
}

// The name without its ending, as the name of the values: programs that read NRRD and MetaImage treat a
// percent sign in it as a pattern of many files, and a line break as the end of the name.
std::string stemForValues(const fs::path& path, const Ending& ending) {
    std::string stem = path.filename().string();
    stem.resize(stem.size() - ending.text.size());
    std::ranges::replace_if(
        stem, [](char c) { return c == '%' || (c >= 0 && c < ' '); }, '_');
    return stem;
}

// The ending of a file to write; fails if Macula does not write that format.
Result<Ending> writtenEndingOf(const fs::path& path) {
    MACULA_TRY(const Ending ending, knownEndingOf(path));
    if (ending.isWritten) return ending;
    return Error{ErrorCode::usage, Text("Volumes are not written to files with the ending {}.", ending.text),
                 path.string(), Text("Known are {}.", volumeFileEndings())};
}

Error cannotWrite(const fs::path& path, Text reason) {
    return {ErrorCode::outputNotWritable, Text("The file could not be put in place: {}.", std::move(reason)),
            path.string(), Text("Check free space and permissions.")};
}

Result<void> writeFormat(Format format, const fs::path& path, const RawImage& image, Progress& progress) {
    if (format == Format::nifti) return writeNifti(path, image, progress);
    progress.beginStage(Text("Writing"), 1);
    auto written = format == Format::nrrd ? writeNrrd(path, image) : writeMetaImage(path, image);
    progress.advance();
    return written;
}

Result<TextHeader> readTextHeader(Format format, const fs::path& path) {
    return format == Format::nrrd ? readNrrdHeader(path) : readMetaImageHeader(path);
}

Result<RawImageLayout> readLayout(Format format, const fs::path& path) {
    if (format == Format::nifti) return readNiftiLayout(path);
    MACULA_TRY(TextHeader header, readTextHeader(format, path));
    return std::move(header.layout);
}

Result<RawImage> readFormat(Format format, const fs::path& path, std::size_t volume, Progress& progress) {
    if (format == Format::nifti) return readNifti(path, progress, volume);
    MACULA_TRY(TextHeader header, readTextHeader(format, path));
    MACULA_TRY_VOID(chooseVolume(header.layout, volume));
    const ValuesInFile values = valuesOfVolume(header.values, header.layout, volume);
    return readValues(std::move(header.layout), values, progress);
}

Error at(const fs::path& path, Error error) {
    if (error.where.empty()) error.where = path.string();
    return error;
}

Result<Ending> checkInput(const fs::path& path) {
    MACULA_TRY(const Ending ending, knownEndingOf(path));
    const Error cannotRead{ErrorCode::inputNotUsable, Text("The file cannot be read."), path.string(),
                           Text("Check the path and its permissions.")};
    std::error_code error;
    if (!fs::is_regular_file(path, error)) {
        if (error == std::errc::permission_denied) return cannotRead;  // for a folder in the path
        return Error{ErrorCode::inputNotUsable, Text("The file does not exist."), path.string(),
                     Text("Check the path.")};
    }
    if (!std::ifstream(path, std::ios::binary)) return cannotRead;
    return ending;
}

const char* nameOf(Format format) {
    return format == Format::nifti ? "NIfTI" : format == Format::nrrd ? "NRRD" : "MetaImage";
}

// A header never lies next to values of another volume, even if the program is killed midway: moves the old
// header away, then puts the values in place, then the new header. If the values cannot be put in place, the
// old header comes back.
Result<void> putAllInPlace(const std::vector<fs::path>& files, const fs::path& draft,
                           const fs::path& workshop) {
    const fs::path& header = files.front();
    if (files.size() == 1) return putInPlace(draft, header);
    std::error_code notThere;
    std::error_code error;
    const fs::path before = workshop / "before";
    const bool replaces = fs::is_regular_file(header, notThere);
    if (replaces) fs::rename(header, before, error);
    if (error) return cannotWrite(header, Text::verbatim(error.message()));
    const fs::path& values = files.back();
    if (const auto placed = putInPlace(workshop / values.filename(), values); !placed) {
        if (replaces) fs::rename(before, header, error);
        return placed.error();
    }
    return putInPlace(draft, header);
}

// `Grid` is a Volume or a LabelMap.
template <class Grid>
Result<void> writeImage(const Grid& grid, std::size_t voxels, const fs::path& path, Progress& progress) try {
    MACULA_TRY(const Ending ending, writtenEndingOf(path));
    MACULA_TRY(const auto files, filesOfVolumeFile(path));
    const std::uint64_t most = std::uint64_t{sizeof(float)} * voxels;
    if (const auto available = availableMemory(); available && most > *available)
        return notEnoughMemory(most, *available);
    // A folder, so that both files of a pair have their final names: the header names the other.
    MACULA_TRY(const Draft workshop, Draft::beside(path, Draft::Kind::folder));
    MACULA_TRY(const RawImage image, rawImageOf(grid, progress));
    std::error_code unknown;
    const auto space = fs::space(workshop.path(), unknown);
    // Without this check MetaIO would print an error.
    if (!unknown && ending.text != ".nii.gz" && space.available < image.data.size()) {
        return Error{ErrorCode::outputNotWritable, Text("There is not enough free space."), path.string(),
                     Text("The file needs {} MB.", image.data.size() / 1'000'000 + 1)};
    }
    // The ending is in lower case, because the libraries choose the format by it. The header names its values
    // by the same stem.
    const fs::path draft = workshop.path() / (stemForValues(path, ending) + std::string(ending.text));
    if (const auto written = writeFormat(ending.format, draft, image, progress); !written)
        return at(path, written.error());
    if (progress.cancelled())
        return Error{ErrorCode::cancelled, Text("Stopped; nothing was written."), {}, {}};
    // Reads the header back, because no library reports every failed write, and readers compare the header
    // with the size of the file. A segmentation of a single slice is not checked, because readers accept no
    // such volume.
    const glm::ivec3 size = image.size;
    const bool isVolume = std::min({size.x, size.y, size.z}) > 1;
    if (isVolume && !readLayout(ending.format, draft))
        return cannotWrite(path, Text("it did not become whole"));
    return putAllInPlace(files, draft, workshop.path());
} catch (const std::bad_alloc&) {
    return notEnoughMemory(std::uint64_t{sizeof(float)} * voxels, availableMemory());
} catch (const std::exception&) {
    return cannotWrite(path, Text("something unforeseen happened"));
}

// A sentence for Provenance::assumptions.
Text whatIsKnownOfUnit(Unit unit) {
    if (unit == Unit::raw)
        return Text(
            "The file does not name the unit of its values: none was assumed. Presets for Hounsfield units "
            "do not fit.");
    return Text(
        "Macula wrote this file, with values in {}; a program that changed them since need "
        "not have said so.",
        unitSymbol(unit));
}

}  // namespace

std::string volumeFileEndings() {
    std::string endings;
    for (const Ending& ending : kEndings) {
        if (ending.isWritten) endings += (endings.empty() ? "" : ", ") + std::string(ending.text);
    }
    return endings;
}

bool isVolumeFileName(const fs::path& path) {
    return endingOf(path) != nullptr;
}

Result<std::vector<fs::path>> filesOfVolumeFile(const fs::path& path) {
    MACULA_TRY(const Ending ending, writtenEndingOf(path));
    std::vector<fs::path> files{path};
    if (ending.detached) files.push_back(path.parent_path() / (stemForValues(path, ending) + ".raw"));
    return files;
}

std::optional<fs::path> valuesFileOf(const fs::path& path) try {
    const Ending* ending = endingOf(path);
    if (ending == nullptr) return {};
    if (ending->format == Format::nifti) return ending->detached ? niftiValuesFile(path) : std::nullopt;
    const auto header = readTextHeader(ending->format, path);
    return header && header->values.file != path ? std::optional(header->values.file) : std::nullopt;
} catch (const std::exception&) {
    return {};
}

Result<void> writeVolumeFile(const Volume& volume, const fs::path& path, Progress& progress) {
    return writeImage(volume, volume.voxelCount(), path, progress);
}

Result<void> writeVolumeFile(const LabelMap& map, const fs::path& path, Progress& progress) {
    return writeImage(map, map.labels().size(), path, progress);
}

Result<VolumeFileInfo> readVolumeFileInfo(const fs::path& path) try {
    MACULA_TRY(const Ending ending, checkInput(path));
    const auto layout = readLayout(ending.format, path);
    if (!layout) return at(path, layout.error());
    return VolumeFileInfo{.format = nameOf(ending.format),
                          .values = std::string(nameOf(layout->type)),
                          .size = layout->size,
                          .worldFromVoxel = layout->worldFromVoxel,
                          .assumptions = layout->assumptions,
                          .isCalibrated = layout->isCalibrated,
                          .volumes = layout->volumes,
                          .axis = layout->axis};
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read the header of this volume"), path.string());
}

Result<std::shared_ptr<const Volume>> readVolumeFile(const fs::path& path, Progress& progress,
                                                     std::size_t number) try {
    MACULA_TRY(const Ending ending, checkInput(path));
    auto image = readFormat(ending.format, path, number, progress);
    if (!image) return at(path, image.error());
    if (progress.cancelled()) return Error{ErrorCode::cancelled, Text("Stopped."), {}, {}};
    image->assumptions.push_back(whatIsKnownOfUnit(image->unit));
    auto volume = volumeOf(std::move(*image), progress);
    if (!volume) return at(path, volume.error());
    return volume;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read this volume"), path.string());
}

}  // namespace macula::formats
