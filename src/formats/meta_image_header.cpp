// https://itk.org/Wiki/ITK/MetaIO/Documentation
#include <algorithm>

#include "formats/text_header.h"

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

struct Parsed {
    Fields fields;
    std::uint64_t bytes = 0;
};

Result<Parsed> parse(const fs::path& path) {
    HeaderLines lines(path);
    Parsed parsed;
    while (!parsed.fields.contains("ElementDataFile")) {  // always the last field
        const auto line = lines.next();
        const std::size_t separator = line ? line->find_first_of("=:") : std::string::npos;
        if (line && trimmed(*line).empty()) continue;
        if (separator == std::string::npos)
            return parsed.fields.contains("NDims") ? headerDamaged()
                                                   : headerNotUsable(Text("This is no MetaImage file."));
        if (!parsed.fields.emplace(trimmed(line->substr(0, separator)), trimmed(line->substr(separator + 1)))
                 .second)
            return headerDamaged();
    }
    parsed.bytes = lines.position();
    return parsed;
}

// The value of the first key that is present: the format has had several names for one field.
std::string firstOf(const Fields& fields, std::initializer_list<const char*> keys) {
    for (const char* key : keys) {
        if (fields.contains(key)) return valueOf(fields, key);
    }
    return {};
}

bool isTrue(const std::string& text) {
    return text.starts_with('T') || text.starts_with('t') || text.starts_with('1');
}

Result<ScalarType> typeOf(const Fields& fields) {
    static const std::map<std::string, ScalarType> kTypes{
        {"MET_CHAR", ScalarType::int8},       {"MET_UCHAR", ScalarType::uint8},
        {"MET_SHORT", ScalarType::int16},     {"MET_USHORT", ScalarType::uint16},
        {"MET_INT", ScalarType::int32},       {"MET_UINT", ScalarType::uint32},
        {"MET_LONG", ScalarType::int32},      {"MET_ULONG", ScalarType::uint32},
        {"MET_LONG_LONG", ScalarType::int64}, {"MET_ULONG_LONG", ScalarType::uint64},
        {"MET_FLOAT", ScalarType::float32},   {"MET_DOUBLE", ScalarType::float64}};
    const std::string name = valueOf(fields, "ElementType");
    const std::string channels = valueOf(fields, "ElementNumberOfChannels");
    if (name.ends_with("_ARRAY") || (!channels.empty() && channels != "1"))
        return headerNotUsable(Text("The image has several values in each voxel; a volume needs one."));
    const auto type = kTypes.find(name);
    if (type != kTypes.end()) return type->second;
    return headerNotUsable(
        Text("The values of the image are neither whole numbers of 8 to 64 bits nor floating-point ones."));
}

// MET_LONG has 4 bytes in the format, but 8 in files of programs that wrote the long of their machine. The
// size of the file shows which, unless the values are compressed.
void widenLongs(const std::string& name, const ValuesInFile& values, RawImageLayout& layout) {
    if (values.compressed || (name != "MET_LONG" && name != "MET_ULONG")) return;
    std::error_code error;
    const std::uint64_t inFile = fs::file_size(values.file, error);
    if (error || inFile < values.offset || inFile - values.offset != 2 * layout.bytes()) return;
    layout.type = name == "MET_LONG" ? ScalarType::int64 : ScalarType::uint64;
    layout.assumptions.emplace_back(
        Text("The values have 8 bytes each, as the size of the file tells, and not 4 as their type says."));
}

Result<glm::dmat4> worldFromVoxelOf(const Fields& fields, RawImageLayout& layout) {
    std::string matrix = firstOf(fields, {"TransformMatrix", "Rotation", "Orientation"});
    if (matrix.empty()) {
        layout.assumptions.push_back(lpsAssumed());
        matrix = "1 0 0 0 1 0 0 0 1";
    }
    std::string spacing = firstOf(fields, {"ElementSpacing", "ElementSize"});
    if (spacing.empty()) {
        layout.isCalibrated = false;
        layout.assumptions.emplace_back(
            Text("The file does not give the distance of the voxels: 1 mm was assumed."));
        spacing = "1 1 1";
    }
    const std::string offset = firstOf(fields, {"Offset", "Position", "Origin"});
    const auto axes = parseNumbers(matrix, 9);
    const auto mm = parseNumbers(spacing, 3);
    const auto origin = parseNumbers(offset.empty() ? "0 0 0" : offset, 3);
    if (!axes || !mm || !origin) return headerDamaged();
    const auto axis = [&](std::size_t n) {
        return glm::dvec3((*axes)[3 * n], (*axes)[3 * n + 1], (*axes)[3 * n + 2]) * (*mm)[n];
    };
    return affine(axis(0), axis(1), axis(2), {(*origin)[0], (*origin)[1], (*origin)[2]});
}

Result<ValuesInFile> valuesOf(const fs::path& path, const Parsed& parsed, const RawImageLayout& layout) {
    const Fields& fields = parsed.fields;
    if (fields.contains("BinaryData") && !isTrue(valueOf(fields, "BinaryData"))) {
        return headerNotUsable(Text("The values are written as text, which Macula does not read."),
                               Text("Write the file with BinaryData = True."));
    }
    ValuesInFile values;
    values.compressed = isTrue(valueOf(fields, "CompressedData"));
    values.bigEndian = isTrue(firstOf(fields, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}));
    const std::string dataFile = valueOf(fields, "ElementDataFile");
    if (lowerCase(dataFile) == "local") {
        values.file = path;
        values.offset = parsed.bytes;
    } else if (dataFile == "LIST" || dataFile.starts_with("LIST ")) {
        return headerNotUsable(Text("The values lie in several files."),
                               Text("Write the volume to one file."));
    } else {
        MACULA_TRY(values.file, besideHeader(path, dataFile));
    }
    const std::string header = valueOf(fields, "HeaderSize");
    const auto bytes = parseNumber<std::int64_t>(header.empty() ? "0" : header);
    std::error_code error;
    const auto inFile = static_cast<std::int64_t>(fs::file_size(values.file, error));
    if (!bytes || *bytes < -1 || *bytes > inFile || error || (values.compressed && *bytes == -1))
        return headerDamaged();
    if (*bytes == -1) {  // the values are at the end
        const std::uint64_t needed = layout.bytes();
        const auto there = static_cast<std::uint64_t>(inFile);
        values.offset = there - std::min(there, needed);
    } else if (*bytes > 0) {
        values.offset = static_cast<std::uint64_t>(*bytes);
    }
    return values;
}

}  // namespace

Result<TextHeader> readMetaImageHeader(const fs::path& path) {
    MACULA_TRY(const Parsed parsed, parse(path));
    const Fields& fields = parsed.fields;
    TextHeader header;
    MACULA_TRY_VOID(checkThreeAxes(valueOf(fields, "NDims")));
    MACULA_TRY(header.layout.size, parseSize(valueOf(fields, "DimSize")));
    MACULA_TRY(header.layout.type, typeOf(fields));
    for (const auto& [key, into] :
         {std::pair{"ElementToIntensityFunctionSlope", &header.layout.slope},
          std::pair{"ElementToIntensityFunctionOffset", &header.layout.intercept}}) {
        if (!fields.contains(key)) continue;
        const auto value = parseNumber<double>(valueOf(fields, key));
        if (!value) return headerDamaged();
        *into = *value;
    }
    readValueNote(valueOf(fields, std::string(kValueNoteField).c_str()), header.layout);
    MACULA_TRY(header.layout.worldFromVoxel, worldFromVoxelOf(fields, header.layout));
    MACULA_TRY(header.values, valuesOf(path, parsed, header.layout));
    widenLongs(valueOf(fields, "ElementType"), header.values, header.layout);
    MACULA_TRY_VOID(checkExtent(header.layout, header.values));
    return header;
}

}  // namespace macula::formats
