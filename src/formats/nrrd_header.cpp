// http://teem.sourceforge.net/nrrd/format.html
#include <algorithm>

#include "formats/nrrd_volumes.h"
#include "formats/text_header.h"

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

Result<ScalarType> typeOf(const std::string& name) {
    static const std::map<std::string, ScalarType> kTypes{{"signed char", ScalarType::int8},
                                                          {"int8", ScalarType::int8},
                                                          {"int8_t", ScalarType::int8},
                                                          {"uchar", ScalarType::uint8},
                                                          {"unsigned char", ScalarType::uint8},
                                                          {"uint8", ScalarType::uint8},
                                                          {"uint8_t", ScalarType::uint8},
                                                          {"short", ScalarType::int16},
                                                          {"short int", ScalarType::int16},
                                                          {"signed short", ScalarType::int16},
                                                          {"signed short int", ScalarType::int16},
                                                          {"int16", ScalarType::int16},
                                                          {"int16_t", ScalarType::int16},
                                                          {"ushort", ScalarType::uint16},
                                                          {"unsigned short", ScalarType::uint16},
                                                          {"unsigned short int", ScalarType::uint16},
                                                          {"uint16", ScalarType::uint16},
                                                          {"uint16_t", ScalarType::uint16},
                                                          {"int", ScalarType::int32},
                                                          {"signed int", ScalarType::int32},
                                                          {"int32", ScalarType::int32},
                                                          {"int32_t", ScalarType::int32},
                                                          {"uint", ScalarType::uint32},
                                                          {"unsigned int", ScalarType::uint32},
                                                          {"uint32", ScalarType::uint32},
                                                          {"uint32_t", ScalarType::uint32},
                                                          {"longlong", ScalarType::int64},
                                                          {"long long", ScalarType::int64},
                                                          {"long long int", ScalarType::int64},
                                                          {"signed long long", ScalarType::int64},
                                                          {"signed long long int", ScalarType::int64},
                                                          {"int64", ScalarType::int64},
                                                          {"int64_t", ScalarType::int64},
                                                          {"ulonglong", ScalarType::uint64},
                                                          {"unsigned long long", ScalarType::uint64},
                                                          {"unsigned long long int", ScalarType::uint64},
                                                          {"uint64", ScalarType::uint64},
                                                          {"uint64_t", ScalarType::uint64},
                                                          {"float", ScalarType::float32},
                                                          {"double", ScalarType::float64}};
    const auto found = kTypes.find(lowerCase(name));
    if (found != kTypes.end()) return found->second;
    return headerNotUsable(
        Text("The values of the image are neither whole numbers of 8 to 64 bits nor floating-point ones."));
}

struct Parsed {
    Fields fields;  // by name in lower case without blanks, because older files spell names differently
    std::uint64_t bytes = 0;    // size of the header, with the blank line after it
    bool hasBlankLine = false;  // after which values may follow
    Fields notes;               // by key
};

Result<Parsed> parse(const fs::path& path) {
    HeaderLines lines(path);
    const auto magic = lines.next();
    if (!magic || !magic->starts_with("NRRD000")) return headerNotUsable(Text("This is no NRRD file."));
    Parsed parsed;
    while (!parsed.hasBlankLine && !lines.atEnd()) {
        const auto line = lines.next();
        if (!line) return headerDamaged();
        if (line->empty()) {
            parsed.hasBlankLine = true;
        } else if ((*line)[0] != '#') {
            // "key:=value" is free metadata; "field: value" describes the image.
            const std::size_t colon = line->find(": ");
            const std::size_t note = line->find(":=");
            if (note != std::string::npos && (colon == std::string::npos || note < colon)) {
                parsed.notes.emplace(line->substr(0, note), line->substr(note + 2));
                continue;
            }
            if (colon == std::string::npos) return headerDamaged();
            std::string name = lowerCase(line->substr(0, colon));
            std::erase(name, ' ');
            if (!parsed.fields.emplace(name, trimmed(line->substr(colon + 2))).second) return headerDamaged();
        }
    }
    parsed.bytes = lines.position();
    return parsed;
}

Result<void> checkAxes(const Fields& fields) {
    for (const std::string& kind : words(lowerCase(valueOf(fields, "kinds")))) {
        if (kind != "domain" && kind != "space" && kind != "none" && kind != "???") {
            return severalValues();
        }
    }
    std::string units = lowerCase(valueOf(fields, "spaceunits"));
    std::replace(units.begin(), units.end(), '"', ' ');
    for (const std::string& unit : words(units)) {
        if (unit != "mm" && unit != "millimeter" && unit != "millimeters" && unit != "???")
            return headerNotUsable(Text("The position of the image is not given in millimetres."));
    }
    return {};
}

// Parses "(1,0,0) (0,1,0) (0,0,1)" into `count` numbers.
std::optional<std::vector<double>> vectors(std::string text, std::size_t count) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '(' || c == ')' || c == ','; }, ' ');
    return parseNumbers(text, count);
}

Result<glm::dmat4> worldFromVoxelOf(const Fields& fields, RawImageLayout& layout) {
    const std::string space = lowerCase(valueOf(fields, "space"));
    glm::dvec3 lpsFromSpace(1.0);
    if (space == "right-anterior-superior" || space == "ras") {
        lpsFromSpace = {-1, -1, 1};
    } else if (space == "left-anterior-superior" || space == "las") {
        lpsFromSpace = {1, -1, 1};
    } else if (space != "left-posterior-superior" && space != "lps") {
        layout.assumptions.push_back(lpsAssumed());
    }
    if (const std::string directions = valueOf(fields, "spacedirections"); !directions.empty()) {
        if (lowerCase(directions).find("none") != std::string::npos) {
            return headerNotUsable(Text("An axis of the image does not lie in space."),
                                   Text("Write one volume to a file of its own."));
        }
        const std::string origin = valueOf(fields, "spaceorigin");
        const auto axes = vectors(directions, 9);
        const auto position = vectors(origin.empty() ? "0 0 0" : origin, 3);
        if (!axes || !position) return headerDamaged();
        const auto at = [&](const std::vector<double>& v, std::size_t n) {
            return glm::dvec3(v[n], v[n + 1], v[n + 2]) * lpsFromSpace;
        };
        return affine(at(*axes, 0), at(*axes, 3), at(*axes, 6), at(*position, 0));
    }
    const std::string spacings = valueOf(fields, "spacings");
    const auto mm = parseNumbers(spacings.empty() ? "1 1 1" : spacings, 3);
    if (!mm) return headerDamaged();
    if (spacings.empty()) {
        layout.isCalibrated = false;
        layout.assumptions.emplace_back(
            Text("The file does not give the distance of the voxels: 1 mm was assumed."));
    }
    return affine({(*mm)[0], 0, 0}, {0, (*mm)[1], 0}, {0, 0, (*mm)[2]}, glm::dvec3(0.0));
}

Result<ValuesInFile> valuesOf(const fs::path& path, const Parsed& parsed, const RawImageLayout& layout,
                              const NrrdVolumes& volumes) {
    const Fields& fields = parsed.fields;
    ValuesInFile values;
    const std::string encoding = lowerCase(valueOf(fields, "encoding"));
    values.compressed = encoding == "gzip" || encoding == "gz";
    if (!values.compressed && encoding != "raw") {
        return headerNotUsable(Text("The values are encoded in a way that Macula does not read."),
                               Text("Write the file with the encoding raw or gzip."));
    }
    const std::string endian = lowerCase(valueOf(fields, "endian"));
    if (endian != "little" && endian != "big" && bytesOf(layout.type) > 1) return headerDamaged();
    values.bigEndian = endian == "big";
    if (volumes.isInterleaved) values.interleaved = volumes.count;
    if (const std::string dataFile = valueOf(fields, "datafile"); !dataFile.empty()) {
        MACULA_TRY(values.file, besideHeader(path, dataFile));
    } else if (parsed.hasBlankLine) {
        values.file = path;
        values.offset = parsed.bytes;
    } else {
        return headerDamaged();
    }
    const std::string lines = valueOf(fields, "lineskip");
    if (!lines.empty() && lines != "0")
        return headerNotUsable(Text("Text stands before the values, which Macula does not read."));
    const std::string skip = valueOf(fields, "byteskip");
    const auto bytes = parseNumber<std::int64_t>(skip.empty() ? "0" : skip);
    std::error_code error;
    const auto inFile = static_cast<std::int64_t>(fs::file_size(values.file, error));
    if (!bytes || *bytes < -1 || error || (values.compressed && *bytes == -1)) return headerDamaged();
    if (*bytes == -1) {  // the values are at the end
        const double needed = double(layout.bytes()) * double(volumes.count);
        values.offset = needed < double(inFile) ? static_cast<std::uint64_t>(double(inFile) - needed) : 0;
    } else if (values.compressed) {
        values.skip = static_cast<std::uint64_t>(*bytes);
    } else {
        values.offset += static_cast<std::uint64_t>(std::min(*bytes, inFile));
    }
    return values;
}

}  // namespace

Result<TextHeader> readNrrdHeader(const fs::path& path) {
    MACULA_TRY(Parsed parsed, parse(path));
    TextHeader header;
    MACULA_TRY(const NrrdVolumes volumes, takeNrrdVolumes(parsed.fields, parsed.notes));
    header.layout.volumes = volumes.count;
    header.layout.axis = volumes.axis;
    MACULA_TRY_VOID(checkThreeAxes(valueOf(parsed.fields, "dimension")));
    MACULA_TRY_VOID(checkAxes(parsed.fields));
    MACULA_TRY(header.layout.size, parseSize(valueOf(parsed.fields, "sizes")));
    MACULA_TRY(header.layout.type, typeOf(valueOf(parsed.fields, "type")));
    MACULA_TRY(header.layout.worldFromVoxel, worldFromVoxelOf(parsed.fields, header.layout));
    readValueNote(valueOf(parsed.notes, std::string(kValueNoteField)), header.layout);
    MACULA_TRY(header.values, valuesOf(path, parsed, header.layout, volumes));
    header.notes = std::move(parsed.notes);
    MACULA_TRY_VOID(checkExtent(header.layout, header.values));
    return header;
}

}  // namespace macula::formats
