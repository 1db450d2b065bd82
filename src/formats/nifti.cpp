#include "formats/nifti.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include "formats/raw_values.h"

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little,
              "headers and data are written as they lie in memory");

constexpr std::size_t kHeaderBytes = 348;
constexpr std::int32_t kNifti2Bytes = 540;
constexpr std::size_t kDataOffset = 352;  // the header, and four zeros: no extensions
constexpr std::size_t kPortion = std::size_t{1} << 20;

// Offsets into the header.
constexpr std::size_t kDim = 40;
constexpr std::size_t kDatatype = 70;
constexpr std::size_t kBitpix = 72;
constexpr std::size_t kPixdim = 76;
constexpr std::size_t kVoxOffset = 108;
constexpr std::size_t kSlope = 112;
constexpr std::size_t kIntercept = 116;
constexpr std::size_t kUnits = 123;
constexpr std::size_t kDescription = 148;  // 80 characters, the last a zero
constexpr std::size_t kDescriptionBytes = 80;
constexpr std::size_t kQformCode = 252;
constexpr std::size_t kSformCode = 254;
constexpr std::size_t kQuatern = 256;
constexpr std::size_t kQoffset = 268;
constexpr std::size_t kSrow = 280;
constexpr std::size_t kMagic = 344;

// The scanner's axes: what DICOM's patient coordinates are, with two of them turned around.
constexpr std::int16_t kScannerCode = 1;
// The qform may differ from the affine by so much at a corner; of a half turn, float32 keeps no more.
constexpr double kQformToleranceMm = 0.01;

const glm::dmat4 kLpsFromRas(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

struct Datatype {
    std::int16_t code;
    ScalarType type;
};
constexpr std::array<Datatype, 8> kDatatypes{{{2, ScalarType::uint8},
                                              {4, ScalarType::int16},
                                              {8, ScalarType::int32},
                                              {16, ScalarType::float32},
                                              {64, ScalarType::float64},
                                              {256, ScalarType::int8},
                                              {512, ScalarType::uint16},
                                              {768, ScalarType::uint32}}};

Error notUsable(std::string message, std::string hint = "Convert it with the program it comes from.") {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

Error cutOff() {
    return notUsable("The file is cut off or damaged.", "Get the file again from where it came.");
}

std::int32_t swapped32(std::uint32_t value) {
    return static_cast<std::int32_t>(__builtin_bswap32(value));
}

class Header {
  public:
    explicit Header(bool swapped = false) : swapped_(swapped) {}

    std::array<std::byte, kDataOffset> bytes{};

    template <class T>
    T get(std::size_t offset) const {
        std::array<std::byte, sizeof(T)> raw;
        std::memcpy(raw.data(), bytes.data() + offset, sizeof(T));
        if (swapped_) std::reverse(raw.begin(), raw.end());
        return std::bit_cast<T>(raw);
    }
    template <class T>
    void set(std::size_t offset, T value) {
        std::memcpy(bytes.data() + offset, &value, sizeof(T));
    }
    bool swapped() const { return swapped_; }

  private:
    bool swapped_;
};

// The rotation of the quaternion (1 - b² - c² - d², b, c, d).
glm::dmat3 rotationOf(double b, double c, double d) {
    const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
    return {glm::dvec3(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)),
            glm::dvec3(2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)),
            glm::dvec3(2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c)};
}

// b, c, d of a rotation, with a >= 0. Of the four ways to get there, the one that divides by the largest.
glm::dvec3 quaternionOf(const glm::dmat3& m) {
    const double xx = m[0][0], yy = m[1][1], zz = m[2][2];
    const std::array<double, 4> squares{1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz,
                                        1 - xx - yy + zz};
    const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
    const double most = 0.5 * std::sqrt(squares[static_cast<std::size_t>(largest)]);
    const double f = 0.25 / most;
    double a = 0.0;
    glm::dvec3 q(0.0);
    switch (largest) {
        case 0:
            a = most;
            q = {f * (m[1][2] - m[2][1]), f * (m[2][0] - m[0][2]), f * (m[0][1] - m[1][0])};
            break;
        case 1:
            a = f * (m[1][2] - m[2][1]);
            q = {most, f * (m[0][1] + m[1][0]), f * (m[0][2] + m[2][0])};
            break;
        case 2:
            a = f * (m[2][0] - m[0][2]);
            q = {f * (m[0][1] + m[1][0]), most, f * (m[1][2] + m[2][1])};
            break;
        default:
            a = f * (m[0][1] - m[1][0]);
            q = {f * (m[0][2] + m[2][0]), f * (m[1][2] + m[2][1]), most};
            break;
    }
    return a < 0.0 ? -q : q;
}

glm::dmat4 qformOf(const Header& header) {
    const auto number = [&](std::size_t offset) { return double(header.get<float>(offset)); };
    const glm::dmat3 rotation = rotationOf(number(kQuatern), number(kQuatern + 4), number(kQuatern + 8));
    const double handedness = number(kPixdim) < 0.0 ? -1.0 : 1.0;
    return affine(rotation[0] * number(kPixdim + 4), rotation[1] * number(kPixdim + 8),
                  rotation[2] * number(kPixdim + 12) * handedness,
                  {number(kQoffset), number(kQoffset + 4), number(kQoffset + 8)});
}

glm::dmat4 sformOf(const Header& header) {
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            m[column][row] =
                double(header.get<float>(kSrow + 16 * std::size_t(row) + 4 * std::size_t(column)));
    }
    return m;
}

double largestDifferenceMm(const glm::dmat4& a, const glm::dmat4& b, const glm::ivec3& size) {
    double most = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 voxel(corner & 1 ? size.x - 1 : 0, corner & 2 ? size.y - 1 : 0,
                               corner & 4 ? size.z - 1 : 0);
        most = std::max(most, glm::length(transformPoint(a, voxel) - transformPoint(b, voxel)));
    }
    return most;
}

Result<Header> headerFor(const RawImageLayout& image) {
    Header header;
    const auto number = [&](std::size_t offset, double value) {
        header.set(offset, static_cast<float>(value));
    };
    const glm::ivec3 size = image.size;
    if (std::max({size.x, size.y, size.z}) > 32767) {
        return Error{
            ErrorCode::usage,
            fmt::format("A NIfTI file holds no volume of {} x {} x {} voxels.", size.x, size.y, size.z),
            {},
            "Write a .nrrd or .mha file."};
    }
    header.set(0, static_cast<std::int32_t>(kHeaderBytes));
    header.set(38, 'r');  // "regular", which some readers ask for
    const std::array<int, 8> dim{3, size.x, size.y, size.z, 1, 1, 1, 1};
    for (std::size_t i = 0; i < dim.size(); ++i) header.set(kDim + 2 * i, static_cast<std::int16_t>(dim[i]));
    for (const Datatype& known : kDatatypes) {
        if (known.type == image.type) header.set(kDatatype, known.code);
    }
    header.set(kBitpix, static_cast<std::int16_t>(8 * bytesOf(image.type)));
    number(kVoxOffset, kDataOffset);
    number(kSlope, image.slope);
    number(kIntercept, image.intercept);
    header.set(kUnits, char{2});  // mm
    std::memcpy(header.bytes.data() + kMagic, "n+1", 4);
    const std::string note = valueNote(image);
    std::memcpy(header.bytes.data() + kDescription, note.data(),
                std::min(note.size(), kDescriptionBytes - 1));

    const glm::dmat4 rasFromVoxel = kLpsFromRas * image.worldFromVoxel;  // the map is its own inverse
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t column = 0; column < 4; ++column)
            number(kSrow + 16 * row + 4 * column, rasFromVoxel[int(column)][int(row)]);
    }
    header.set(kSformCode, kScannerCode);

    glm::dmat3 axes(rasFromVoxel);
    glm::dvec3 spacing(0.0);
    for (int axis = 0; axis < 3; ++axis) {
        spacing[axis] = glm::length(axes[axis]);
        axes[axis] /= spacing[axis];
    }
    const double handedness = glm::determinant(axes) < 0.0 ? -1.0 : 1.0;
    axes[2] *= handedness;
    const glm::dvec3 quaternion = quaternionOf(axes);
    number(kPixdim, handedness);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        number(kPixdim + 4 + 4 * axis, spacing[int(axis)]);
        number(kQuatern + 4 * axis, quaternion[int(axis)]);
        number(kQoffset + 4 * axis, rasFromVoxel[3][int(axis)]);
    }
    if (largestDifferenceMm(qformOf(header), sformOf(header), size) <= kQformToleranceMm) {
        header.set(kQformCode, kScannerCode);
    } else {  // sheared: a rotation and three spacings cannot say it, and half the truth is none
        for (std::size_t offset = kQuatern; offset < kSrow; offset += 4) number(offset, 0.0);
        number(kPixdim, 1.0);
    }
    return header;
}

struct CloseGz {
    void operator()(gzFile file) const { gzclose(file); }
};
using GzFile = std::unique_ptr<std::remove_pointer_t<gzFile>, CloseGz>;

struct Opened {
    fs::path path;
    Header header;
    bool compressed = false;
};

Result<Opened> open(const fs::path& path) {
    const GzFile file(gzopen(path.c_str(), "rb"));
    if (!file) return notUsable("The file cannot be read.", "Check the path and its permissions.");
    std::array<std::byte, kDataOffset> bytes{};
    const int got = gzread(file.get(), bytes.data(), kHeaderBytes);
    std::int32_t first = 0;
    std::memcpy(&first, bytes.data(), sizeof(first));
    const bool swapped = first == swapped32(kHeaderBytes);
    if (first == kNifti2Bytes || first == swapped32(kNifti2Bytes)) {
        return notUsable("This is a NIfTI-2 file; Macula reads NIfTI-1.");
    }
    if (got < 4 || !(swapped || first == std::int32_t(kHeaderBytes)))
        return notUsable("This is no NIfTI file.");
    if (got < static_cast<int>(kHeaderBytes)) return cutOff();
    Opened opened{path, Header(swapped), gzdirect(file.get()) == 0};
    opened.header.bytes = bytes;
    return opened;
}

Result<ScalarType> typeOf(std::int16_t code) {
    for (const Datatype& known : kDatatypes) {
        if (known.code == code) return known.type;
    }
    constexpr std::int16_t kRgb = 128, kRgba = 2304;
    if (code == kRgb || code == kRgba) {
        return notUsable("The image is in colour; a volume needs one value in each voxel.");
    }
    return notUsable(
        fmt::format("The values of the image have NIfTI's data type {}; Macula reads whole numbers of "
                    "8 to 32 bits and floating-point ones.",
                    code));
}

Result<glm::ivec3> sizeOf(const Header& header) {
    const int axes = header.get<std::int16_t>(kDim);
    if (axes < 1 || axes > 7) return notUsable("The header of the NIfTI file is damaged.");
    std::array<int, 7> length{1, 1, 1, 1, 1, 1, 1};
    for (std::size_t axis = 0; axis < std::size_t(axes); ++axis) {
        length[axis] = header.get<std::int16_t>(kDim + 2 + 2 * axis);
        if (length[axis] < 1) return notUsable("The header of the NIfTI file is damaged.");
    }
    if (length[3] > 1) {
        return notUsable(
            fmt::format("The file holds {} volumes, one for each point in time; Macula reads one.",
                        length[3]),
            "Write one of them to a file of its own.");
    }
    if (length[4] > 1 || length[5] > 1 || length[6] > 1) {
        return notUsable("The image has several values in each voxel; a volume needs one.");
    }
    return glm::ivec3(length[0], length[1], length[2]);
}

// Millimetres in one unit of the header; mm when it does not say.
double unitMm(const Header& header) {
    const int units = std::to_integer<int>(header.bytes[kUnits]) & 7;
    return units == 1 ? 1000.0 : units == 3 ? 0.001 : 1.0;
}

glm::dmat4 rasFromVoxelOf(const Header& header, const glm::ivec3& size,
                          std::vector<std::string>& assumptions) {
    const bool hasSform = header.get<std::int16_t>(kSformCode) > 0;
    const bool hasQform = header.get<std::int16_t>(kQformCode) > 0;
    if (hasSform) {
        const glm::dmat4 sform = sformOf(header);
        if (hasQform) {
            const double differenceMm = largestDifferenceMm(sform, qformOf(header), size) * unitMm(header);
            constexpr double kNoticeableMm = 0.1;
            if (differenceMm > kNoticeableMm) {
                assumptions.push_back(
                    fmt::format("The file gives two positions in the patient that differ by up to "
                                "{:.1f} mm (sform and qform): the sform was taken.",
                                differenceMm));
            }
        }
        return sform;
    }
    if (hasQform) return qformOf(header);
    assumptions.emplace_back(
        "The file does not say how the image lies in the patient: its axes were taken to lead to the right, "
        "to the front and up. Left and right may be exchanged.");
    const auto spacing = [&](std::size_t axis) { return double(header.get<float>(kPixdim + 4 * axis)); };
    return affine({spacing(1), 0, 0}, {0, spacing(2), 0}, {0, 0, spacing(3)}, glm::dvec3(0.0));
}

Result<ValuesInFile> valuesOf(const Opened& opened) {
    const double offset = opened.header.get<float>(kVoxOffset);
    constexpr double kMost = 1e9;  // what extensions of the header may hold, and some
    if (!(offset >= double(kHeaderBytes) && offset <= kMost))
        return notUsable("The header of the NIfTI file is damaged.");
    ValuesInFile values{
        .file = opened.path, .compressed = opened.compressed, .bigEndian = opened.header.swapped()};
    (opened.compressed ? values.skip : values.offset) = static_cast<std::uint64_t>(offset);
    return values;
}

Result<RawImageLayout> layoutOf(const Opened& opened) {
    const Header& header = opened.header;
    std::array<char, 4> magic{};
    std::memcpy(magic.data(), header.bytes.data() + kMagic, magic.size());
    if (std::memcmp(magic.data(), "ni1", 4) == 0) {
        return notUsable("The header and the image lie in two files (.hdr and .img).",
                         "Write them to one .nii file.");
    }
    if (std::memcmp(magic.data(), "n+1", 4) != 0) {
        return notUsable("This is an ANALYZE file, which does not tell left from right.",
                         "Write it as NIfTI.");
    }
    RawImageLayout layout;
    MACULA_TRY(layout.size, sizeOf(header));
    MACULA_TRY(layout.type, typeOf(header.get<std::int16_t>(kDatatype)));
    const double slope = header.get<float>(kSlope);
    const double intercept = header.get<float>(kIntercept);
    if (std::isfinite(slope) && slope != 0.0 && std::isfinite(intercept)) {  // else: raw values are meant
        layout.slope = slope;
        layout.intercept = intercept;
    }
    readValueNote({reinterpret_cast<const char*>(header.bytes.data() + kDescription), kDescriptionBytes},
                  layout);
    glm::dmat4 rasFromVoxel = rasFromVoxelOf(header, layout.size, layout.assumptions);
    const double scale = unitMm(header);
    for (int column = 0; column < 4; ++column)
        rasFromVoxel[column] = glm::dvec4(glm::dvec3(rasFromVoxel[column]) * scale, rasFromVoxel[column].w);
    layout.worldFromVoxel = kLpsFromRas * rasFromVoxel;
    if (!isInvertibleAffine(layout.worldFromVoxel)) {
        return notUsable(
            "The position of the image in the patient is not usable: its axes do not span a volume.");
    }
    MACULA_TRY(const ValuesInFile values, valuesOf(opened));
    MACULA_TRY_VOID(checkExtent(layout, values));
    return layout;
}

}  // namespace

Result<void> writeNifti(const fs::path& path, const RawImage& image, Progress& progress) {
    MACULA_TRY(const Header header, headerFor(image));
    const auto failed = [] {
        return Error{ErrorCode::outputNotWritable,
                     "The file could not be written.",
                     {},
                     "Check free space and permissions."};
    };
    // Level 1 takes a third of the time of level 6, and makes files a tenth larger. T: no compression.
    GzFile file(gzopen(path.c_str(), path.extension() == ".gz" ? "wb1" : "wbT"));
    if (!file) return failed();
    gzbuffer(file.get(), kPortion);
    progress.beginStage("Writing", (image.data.size() + kPortion - 1) / kPortion);
    if (gzwrite(file.get(), header.bytes.data(), kDataOffset) != static_cast<int>(kDataOffset))
        return failed();
    for (std::size_t at = 0; at < image.data.size(); at += kPortion) {
        const auto length = static_cast<unsigned>(std::min(kPortion, image.data.size() - at));
        if (gzwrite(file.get(), image.data.data() + at, length) != static_cast<int>(length)) return failed();
        progress.advance();
        if (progress.cancelled()) return Error{ErrorCode::cancelled, "Stopped; nothing was written.", {}, {}};
    }
    if (gzclose(file.release()) != Z_OK) return failed();
    return {};
}

Result<RawImageLayout> readNiftiLayout(const fs::path& path) {
    MACULA_TRY(const Opened opened, open(path));
    return layoutOf(opened);
}

Result<RawImage> readNifti(const fs::path& path, Progress& progress) {
    MACULA_TRY(const Opened opened, open(path));
    MACULA_TRY(RawImageLayout layout, layoutOf(opened));
    MACULA_TRY(const ValuesInFile values, valuesOf(opened));
    return readValues(std::move(layout), values, progress);
}

}  // namespace macula::formats
