#include "formats/itk_image_file.h"

#include "base/itk_for_clang.h"

#include <itkMetaDataObject.h>
#include <itkMetaImageIO.h>
#include <itkNrrdImageIO.h>

#include <array>
#include <fstream>

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

struct Component {
    itk::IOComponentEnum itk;
    ScalarType type;
};
constexpr std::array<Component, 8> kComponents{{{itk::IOComponentEnum::CHAR, ScalarType::int8},
                                                {itk::IOComponentEnum::UCHAR, ScalarType::uint8},
                                                {itk::IOComponentEnum::SHORT, ScalarType::int16},
                                                {itk::IOComponentEnum::USHORT, ScalarType::uint16},
                                                {itk::IOComponentEnum::INT, ScalarType::int32},
                                                {itk::IOComponentEnum::UINT, ScalarType::uint32},
                                                {itk::IOComponentEnum::FLOAT, ScalarType::float32},
                                                {itk::IOComponentEnum::DOUBLE, ScalarType::float64}}};

itk::IOComponentEnum componentOf(ScalarType type) {
    for (const Component& component : kComponents) {
        if (component.type == type) return component.itk;
    }
    return itk::IOComponentEnum::UNKNOWNCOMPONENTTYPE;
}

// The region of the whole image, for ITK to write.
itk::ImageIORegion wholeOf(const glm::ivec3& size) {
    itk::ImageIORegion region(3);
    for (unsigned axis = 0; axis < 3; ++axis) {
        region.SetIndex(axis, 0);
        region.SetSize(axis, static_cast<itk::SizeValueType>(size[int(axis)]));
    }
    return region;
}

Result<void> write(itk::ImageIOBase& io, const fs::path& path, const RawImage& image) try {
    io.SetFileName(path.string());
    io.SetNumberOfDimensions(3);
    for (unsigned axis = 0; axis < 3; ++axis) {
        const glm::dvec3 column(image.worldFromVoxel[int(axis)]);
        const double spacing = glm::length(column);
        io.SetDimensions(axis, static_cast<itk::SizeValueType>(image.size[int(axis)]));
        io.SetSpacing(axis, spacing);
        io.SetOrigin(axis, image.worldFromVoxel[3][int(axis)]);
        // Need not be orthonormal: both formats keep a shear as it is.
        io.SetDirection(axis,
                        std::vector<double>{column.x / spacing, column.y / spacing, column.z / spacing});
    }
    io.SetComponentType(componentOf(image.type));
    io.SetPixelType(itk::IOPixelEnum::SCALAR);
    io.SetNumberOfComponents(1);
    io.SetIORegion(wholeOf(image.size));
    if (const std::string note = valueNote(image); !note.empty())
        itk::EncapsulateMetaData<std::string>(io.GetMetaDataDictionary(), std::string(kValueNoteField), note);
    io.Write(image.data.data());
    // MetaIO does not notice a full disk.
    std::error_code error;
    std::uint64_t written = 0;
    for (const auto& file : fs::directory_iterator(path.parent_path(), error))
        written += file.file_size(error);
    if (error || written <= image.data.size()) return notWritten();
    return {};
} catch (const std::bad_alloc&) {
    throw;
} catch (const std::exception&) {
    return notWritten();
}

// Splits a file into a header, which names the file of the values, and that file.
Result<void> detachValues(const fs::path& whole, const fs::path& headerPath, const RawImage& image) {
    constexpr std::string_view kValuesFollow = "LOCAL\n";
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(whole, error);
    if (error || bytes <= image.data.size()) return notWritten();
    std::string header(bytes - image.data.size(), '\0');
    if (!std::ifstream(whole, std::ios::binary)
             .read(header.data(), static_cast<std::streamsize>(header.size())) ||
        !header.ends_with(kValuesFollow))
        return notWritten();
    fs::remove(whole, error);
    header.resize(header.size() - kValuesFollow.size());
    const fs::path valuesPath = fs::path(headerPath).replace_extension(".raw");
    std::ofstream headerFile(headerPath, std::ios::binary);
    headerFile << header << valuesPath.filename().string() << '\n';
    headerFile.close();
    std::ofstream values(valuesPath, std::ios::binary);
    values.write(reinterpret_cast<const char*>(image.data.data()),
                 static_cast<std::streamsize>(image.data.size()));
    values.close();
    if (!headerFile || !values) return notWritten();
    return {};
}

}  // namespace

Result<void> writeNrrd(const fs::path& path, const RawImage& image) {
    return write(*itk::NrrdImageIO::New(), path, image);
}

Result<void> writeMetaImage(const fs::path& path, const RawImage& image) {
    if (path.extension() != ".mhd") return write(*itk::MetaImageIO::New(), path, image);
    // MetaIO reads a percent sign anywhere in the path of separate values as a pattern of many files.
    const fs::path whole = fs::path(path).replace_extension(".mha");
    MACULA_TRY_VOID(write(*itk::MetaImageIO::New(), whole, image));
    return detachValues(whole, path, image);
}

}  // namespace macula::formats
