#include "formats/nifti.h"

#include <nifti2_io.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

#include "formats/raw_values.h"

namespace macula::formats {

namespace {

namespace fs = std::filesystem;

static_assert(std::endian::native == std::endian::little,
              "headers and data are written as they lie in memory");

constexpr std::size_t kHeaderBytes = sizeof(nifti_1_header);
static_assert(kHeaderBytes == 348);
constexpr std::size_t kHeader2Bytes = sizeof(nifti_2_header);
static_assert(kHeader2Bytes == 540);
constexpr std::array<char, 4> kNoExtensions{};  // the four bytes after the header: no extensions follow
constexpr std::size_t kDataOffset = kHeaderBytes + kNoExtensions.size();
constexpr std::size_t kPortion = std::size_t{1} << 20;

// The qform may differ from the affine by this much at a corner: float32 is no more precise for half a turn.
constexpr double kQformToleranceMm = 0.01;

const glm::dmat4 kLpsFromRas(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

struct Datatype {
    std::int16_t code;
    ScalarType type;
};
constexpr std::array<Datatype, 10> kDatatypes{{{DT_UINT8, ScalarType::uint8},
                                               {DT_INT16, ScalarType::int16},
                                               {DT_INT32, ScalarType::int32},
                                               {DT_FLOAT32, ScalarType::float32},
                                               {DT_FLOAT64, ScalarType::float64},
                                               {DT_INT8, ScalarType::int8},
                                               {DT_UINT16, ScalarType::uint16},
                                               {DT_UINT32, ScalarType::uint32},
                                               {DT_INT64, ScalarType::int64},
                                               {DT_UINT64, ScalarType::uint64}}};

Error notUsable(Text message, Text hint = Text("Convert it with the program it comes from.")) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

std::int32_t swapped32(std::uint32_t value) {
    return static_cast<std::int32_t>(__builtin_bswap32(value));
}

// The affine of the qform, for either version of the format.
template <class Header>
glm::dmat4 qformOf(const Header& header) {
    // Multiplies by the spacings here, because the library replaces those that are not positive by 1.
    const nifti_dmat44 rows = nifti_quatern_to_dmat44(header.quatern_b, header.quatern_c, header.quatern_d, 0,
                                                      0, 0, 1, 1, 1, header.pixdim[0]);
    const auto axis = [&](int n) {
        return glm::dvec3(rows.m[0][n], rows.m[1][n], rows.m[2][n]) *
               double(header.pixdim[static_cast<std::size_t>(n) + 1]);
    };
    return affine(axis(0), axis(1), axis(2), {header.qoffset_x, header.qoffset_y, header.qoffset_z});
}

template <class Header>
glm::dmat4 sformOf(const Header& header) {
    glm::dmat4 m(1.0);
    for (std::size_t column = 0; column < 4; ++column) {
        const auto c = static_cast<int>(column);
        m[c][0] = header.srow_x[column];
        m[c][1] = header.srow_y[column];
        m[c][2] = header.srow_z[column];
    }
    return m;
}

double largestDifferenceMm(const glm::dmat4& a, const glm::dmat4& b, const glm::ivec3& size) {
    double most = 0.0;
    for (const glm::dvec3& voxel : cornersOf({glm::dvec3(0.0), glm::dvec3(size - 1)}))
        most = std::max(most, glm::length(transformPoint(a, voxel) - transformPoint(b, voxel)));
    return most;
}

Result<nifti_1_header> headerFor(const RawImageLayout& image) {
    nifti_1_header header{};
    const glm::ivec3 size = image.size;
    if (std::max({size.x, size.y, size.z}) > 32767) {
        return Error{ErrorCode::usage,
                     Text("A NIfTI file holds no volume of {} x {} x {} voxels.", size.x, size.y, size.z),
                     {},
                     Text("Write a .nrrd or .mha file.")};
    }
    header.sizeof_hdr = kHeaderBytes;
    header.regular = 'r';  // some readers require it
    const std::array<int, 8> dim{3, size.x, size.y, size.z, 1, 1, 1, 1};
    std::transform(dim.begin(), dim.end(), header.dim, [](int n) { return static_cast<short>(n); });
    for (const Datatype& known : kDatatypes) {
        if (known.type == image.type) header.datatype = known.code;
    }
    header.bitpix = static_cast<short>(8 * bytesOf(image.type));
    header.vox_offset = kDataOffset;
    header.scl_slope = static_cast<float>(image.slope);
    header.scl_inter = static_cast<float>(image.intercept);
    header.xyzt_units = NIFTI_UNITS_MM;
    std::memcpy(header.magic, "n+1", sizeof(header.magic));
    const std::string note = valueNote(image);
    std::memcpy(header.descrip, note.data(), std::min(note.size(), sizeof(header.descrip) - 1));

    const glm::dmat4 rasFromVoxel = kLpsFromRas * image.worldFromVoxel;  // the map is its own inverse
    nifti_dmat44 rows{};
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) rows.m[row][column] = rasFromVoxel[column][row];
        header.srow_x[column] = static_cast<float>(rows.m[0][column]);
        header.srow_y[column] = static_cast<float>(rows.m[1][column]);
        header.srow_z[column] = static_cast<float>(rows.m[2][column]);
    }
    // The scanner's coordinates are DICOM's patient coordinates with two axes reversed.
    header.sform_code = NIFTI_XFORM_SCANNER_ANAT;

    std::array<double, 10> q{};
    nifti_dmat44_to_quatern(rows, &q[0], &q[1], &q[2], &q[3], &q[4], &q[5], &q[6], &q[7], &q[8], &q[9]);
    const auto at = [&](std::size_t n) { return static_cast<float>(q[n]); };
    nifti_1_header withQform = header;
    withQform.qform_code = NIFTI_XFORM_SCANNER_ANAT;
    withQform.quatern_b = at(0), withQform.quatern_c = at(1), withQform.quatern_d = at(2);
    withQform.qoffset_x = at(3), withQform.qoffset_y = at(4), withQform.qoffset_z = at(5);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        header.pixdim[1 + axis] = withQform.pixdim[1 + axis] = at(6 + axis);
    }
    withQform.pixdim[0] = at(9);
    header.pixdim[0] = 1.0f;
    // A sheared image gets no qform: a rotation and three spacings cannot express a shear.
    const bool isTrue = largestDifferenceMm(qformOf(withQform), sformOf(header), size) <= kQformToleranceMm;
    return isTrue ? withQform : header;
}

struct CloseGz {
    void operator()(gzFile file) const { gzclose(file); }
};
using GzFile = std::unique_ptr<std::remove_pointer_t<gzFile>, CloseGz>;

// The fields that are used of a header of either version, under their NIfTI names.
struct Header {
    std::int64_t sizeof_hdr = 0;
    std::string magic;  // four characters
    int datatype = 0;
    std::array<std::int64_t, 8> dim{};
    std::array<double, 8> pixdim{};
    double vox_offset = 0.0;
    double toffset = 0.0;
    double scl_slope = 0.0, scl_inter = 0.0;
    int qform_code = 0, sform_code = 0;
    double quatern_b = 0.0, quatern_c = 0.0, quatern_d = 0.0;
    double qoffset_x = 0.0, qoffset_y = 0.0, qoffset_z = 0.0;
    std::array<double, 4> srow_x{}, srow_y{}, srow_z{};
    int xyzt_units = 0;
    std::string descrip;
};

// The library's structs are packed: their fields are copied one by one.
template <class Packed>
Header headerOf(const Packed& packed) {
    Header header{.sizeof_hdr = packed.sizeof_hdr,
                  .magic = std::string(packed.magic, 4),
                  .datatype = packed.datatype,
                  .vox_offset = static_cast<double>(packed.vox_offset),
                  .toffset = packed.toffset,
                  .scl_slope = packed.scl_slope,
                  .scl_inter = packed.scl_inter,
                  .qform_code = packed.qform_code,
                  .sform_code = packed.sform_code,
                  .quatern_b = packed.quatern_b,
                  .quatern_c = packed.quatern_c,
                  .quatern_d = packed.quatern_d,
                  .qoffset_x = packed.qoffset_x,
                  .qoffset_y = packed.qoffset_y,
                  .qoffset_z = packed.qoffset_z,
                  .xyzt_units = packed.xyzt_units,
                  .descrip = std::string(packed.descrip, sizeof(packed.descrip))};
    for (std::size_t i = 0; i < header.dim.size(); ++i) {
        header.dim[i] = packed.dim[i];
        header.pixdim[i] = packed.pixdim[i];
    }
    for (std::size_t i = 0; i < header.srow_x.size(); ++i) {
        header.srow_x[i] = packed.srow_x[i];
        header.srow_y[i] = packed.srow_y[i];
        header.srow_z[i] = packed.srow_z[i];
    }
    return header;
}

struct Opened {
    fs::path path;
    Header header;
    bool swapped = false;
    bool compressed = false;

    // The values lie in a file of their own.
    bool isPair() const { return header.magic.starts_with("ni") && isNifti(); }
    bool isNifti() const {
        return header.magic == std::string_view(isWide() ? "n+2" : "n+1", 4) ||
               header.magic == std::string_view(isWide() ? "ni2" : "ni1", 4);
    }
    bool isWide() const { return header.sizeof_hdr == std::int64_t(kHeader2Bytes); }
};

Result<Opened> open(const fs::path& path) {
    const GzFile file(gzopen(path.c_str(), "rb"));
    if (!file)
        return notUsable(Text("The file cannot be read."), Text("Check the path and its permissions."));
    std::array<char, kHeader2Bytes> bytes{};
    int got = gzread(file.get(), bytes.data(), kHeaderBytes);
    // A small file may end before this, and stray bytes after its gzip stream make the second read fail.
    if (got == static_cast<int>(kHeaderBytes))
        got += std::max(gzread(file.get(), bytes.data() + kHeaderBytes, kHeader2Bytes - kHeaderBytes), 0);
    std::int32_t first = 0;
    std::memcpy(&first, bytes.data(), sizeof first);
    const auto isSize = [&](std::size_t size) {
        return first == std::int32_t(size) || first == swapped32(static_cast<std::uint32_t>(size));
    };
    if (got < 4 || (!isSize(kHeaderBytes) && !isSize(kHeader2Bytes)))
        return notUsable(Text("This is no NIfTI file."));
    const std::size_t size = isSize(kHeader2Bytes) ? kHeader2Bytes : kHeaderBytes;
    if (got < static_cast<int>(size)) return cutOff();
    Opened opened{.path = path, .header = {}, .swapped = first != std::int32_t(size)};
    opened.compressed = gzdirect(file.get()) == 0;
    if (size == kHeader2Bytes) {
        nifti_2_header wide{};
        std::memcpy(&wide, bytes.data(), kHeader2Bytes);
        if (opened.swapped) nifti_swap_as_nifti2(&wide);
        opened.header = headerOf(wide);
    } else {
        nifti_1_header narrow{};
        std::memcpy(&narrow, bytes.data(), kHeaderBytes);
        if (opened.swapped) nifti_swap_as_nifti1(&narrow);
        opened.header = headerOf(narrow);
    }
    return opened;
}

Result<ScalarType> typeOf(int code) {
    for (const Datatype& known : kDatatypes) {
        if (known.code == code) return known.type;
    }
    if (code == DT_RGB24 || code == DT_RGBA32) {
        return notUsable(Text("The image is in colour; a volume needs one value in each voxel."));
    }
    return notUsable(
        Text("The values of the image have NIfTI's data type {}; Macula reads whole numbers of "
             "8 to 64 bits and floating-point ones.",
             code));
}

struct Extent {
    glm::ivec3 size{0};
    std::size_t volumes = 1;
};

Result<Extent> extentOf(const Header& header) {
    const std::int64_t axes = header.dim[0];
    if (axes < 1 || axes > 7) return notUsable(Text("The header of the NIfTI file is damaged."));
    std::array<std::int64_t, 7> length{1, 1, 1, 1, 1, 1, 1};
    constexpr std::int64_t kMost = std::numeric_limits<int>::max();
    for (std::size_t axis = 0; axis < std::size_t(axes); ++axis) {
        length[axis] = header.dim[axis + 1];
        if (length[axis] < 1 || length[axis] > kMost)
            return notUsable(Text("The header of the NIfTI file is damaged."));
    }
    if (length[4] > 1 || length[5] > 1 || length[6] > 1) {
        return notUsable(Text("The image has several values in each voxel; a volume needs one."));
    }
    return Extent{glm::ivec3(length[0], length[1], length[2]), static_cast<std::size_t>(length[3])};
}

// Millimetres in one unit of the header; 1 if the header names no unit.
double unitMm(const Header& header) {
    const int units = XYZT_TO_SPACE(header.xyzt_units);
    return units == NIFTI_UNITS_METER ? 1000.0 : units == NIFTI_UNITS_MICRON ? 0.001 : 1.0;
}

// Of the fourth axis, which the format keeps for time, or for a spectrum where the unit is one.
VolumeAxis axisOf(const Header& header) {
    VolumeAxis axis;
    double factor = 1.0;
    switch (XYZT_TO_TIME(header.xyzt_units)) {
        case NIFTI_UNITS_SEC:
            axis.unit = "ms", factor = 1000.0;
            break;
        case NIFTI_UNITS_MSEC:
            axis.unit = "ms";
            break;
        case NIFTI_UNITS_USEC:
            axis.unit = "ms", factor = 0.001;
            break;
        case NIFTI_UNITS_HZ:
            axis.unit = "Hz";
            break;
        case NIFTI_UNITS_PPM:
            axis.unit = "ppm";
            break;
        case NIFTI_UNITS_RADS:
            axis.unit = "rad/s";
            break;
        default:
            break;
    }
    const double step = header.pixdim[4] * factor;
    if (std::isfinite(step) && step > 0.0) axis.step = step;
    if (std::isfinite(header.toffset)) axis.first = header.toffset * factor;
    return axis;
}

glm::dmat4 rasFromVoxelOf(const Header& header, const glm::ivec3& size, std::vector<Text>& assumptions) {
    const bool hasSform = header.sform_code > 0;
    const bool hasQform = header.qform_code > 0;
    if (hasSform) {
        const glm::dmat4 sform = sformOf(header);
        if (hasQform) {
            const double differenceMm = largestDifferenceMm(sform, qformOf(header), size) * unitMm(header);
            constexpr double kNoticeableMm = 0.1;
            if (differenceMm > kNoticeableMm) {
                assumptions.push_back(
                    Text("The file gives two positions in the patient that differ by up to "
                         "{:.1f} mm (sform and qform): the sform was taken.",
                         differenceMm));
            }
        }
        return sform;
    }
    if (hasQform) return qformOf(header);
    assumptions.emplace_back(Text(
        "The file does not say how the image lies in the patient: its axes were taken to lead to the right, "
        "to the front and up. Left and right may be exchanged."));
    return affine({header.pixdim[1], 0, 0}, {0, header.pixdim[2], 0}, {0, 0, header.pixdim[3]},
                  glm::dvec3(0.0));
}

// The file with the values of a pair (.hdr and .img), which may be compressed.
Result<fs::path> valuesBeside(const fs::path& header) {
    for (const char* ending : {".img", ".IMG", ".img.gz", ".IMG.GZ"}) {
        const fs::path values = fs::path(header).replace_extension(ending);
        std::error_code error;
        if (fs::is_regular_file(values, error)) return values;
    }
    return notUsable(Text("The file with the values (.img) is missing."), Text("Put it beside the header."));
}

Result<ValuesInFile> valuesOf(const Opened& opened) {
    const double offset = opened.header.vox_offset;
    constexpr double kMost = 1e9;  // more than extensions of the header ever need
    const double least = opened.isPair() ? 0.0 : static_cast<double>(opened.header.sizeof_hdr);
    if (!(offset >= least && offset <= kMost))
        return notUsable(Text("The header of the NIfTI file is damaged."));
    ValuesInFile values{.file = opened.path, .compressed = opened.compressed, .bigEndian = opened.swapped};
    if (opened.isPair()) {
        MACULA_TRY(values.file, valuesBeside(opened.path));
        const GzFile file(gzopen(values.file.c_str(), "rb"));
        char first = 0;
        values.compressed = file && gzread(file.get(), &first, 1) == 1 && gzdirect(file.get()) == 0;
    }
    (values.compressed ? values.skip : values.offset) = static_cast<std::uint64_t>(offset);
    return values;
}

Result<RawImageLayout> layoutOf(const Opened& opened) {
    const Header& header = opened.header;
    if (opened.isWide() && !opened.isNifti())
        return notUsable(Text("The header of the NIfTI file is damaged."));
    if (!opened.isNifti()) {
        return notUsable(Text("This is an ANALYZE file, which does not tell left from right."),
                         Text("Write it as NIfTI."));
    }
    RawImageLayout layout;
    MACULA_TRY(const Extent extent, extentOf(header));
    layout.size = extent.size;
    layout.volumes = extent.volumes;
    if (extent.volumes > 1) layout.axis = axisOf(header);
    MACULA_TRY(layout.type, typeOf(header.datatype));
    const double slope = header.scl_slope;
    const double intercept = header.scl_inter;
    if (std::isfinite(slope) && slope != 0.0 && std::isfinite(intercept)) {  // otherwise raw values are meant
        layout.slope = slope;
        layout.intercept = intercept;
    }
    readValueNote(header.descrip, layout);
    glm::dmat4 rasFromVoxel = rasFromVoxelOf(header, layout.size, layout.assumptions);
    const double scale = unitMm(header);
    for (int column = 0; column < 4; ++column)
        rasFromVoxel[column] = glm::dvec4(glm::dvec3(rasFromVoxel[column]) * scale, rasFromVoxel[column].w);
    layout.worldFromVoxel = kLpsFromRas * rasFromVoxel;
    if (!isInvertibleAffine(layout.worldFromVoxel)) {
        return notUsable(
            Text("The position of the image in the patient is not usable: its axes do not span a volume."));
    }
    MACULA_TRY(const ValuesInFile values, valuesOf(opened));
    MACULA_TRY_VOID(checkExtent(layout, values));
    return layout;
}

}  // namespace

std::optional<fs::path> niftiValuesFile(const fs::path& path) {
    const auto opened = open(path);
    if (!opened || !opened->isPair()) return {};
    const auto values = valuesBeside(path);
    return values ? std::optional(*values) : std::nullopt;
}

Result<void> writeNifti(const fs::path& path, const RawImage& image, Progress& progress) {
    MACULA_TRY(const nifti_1_header header, headerFor(image));
    // Level 1 takes a third of the time of level 6, and makes files a tenth larger. T: no compression.
    GzFile file(gzopen(path.c_str(), path.extension() == ".gz" ? "wb1" : "wbT"));
    if (!file) return notWritten();
    gzbuffer(file.get(), kPortion);
    progress.beginStage(Text("Writing"), (image.data.size() + kPortion - 1) / kPortion);
    if (gzwrite(file.get(), &header, kHeaderBytes) != static_cast<int>(kHeaderBytes) ||
        gzwrite(file.get(), kNoExtensions.data(), kNoExtensions.size()) !=
            static_cast<int>(kNoExtensions.size()))
        return notWritten();
    for (std::size_t at = 0; at < image.data.size(); at += kPortion) {
        const auto length = static_cast<unsigned>(std::min(kPortion, image.data.size() - at));
        if (gzwrite(file.get(), image.data.data() + at, length) != static_cast<int>(length))
            return notWritten();
        progress.advance();
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Stopped; nothing was written."), {}, {}};
    }
    if (gzclose(file.release()) != Z_OK) return notWritten();
    return {};
}

Result<RawImageLayout> readNiftiLayout(const fs::path& path) {
    MACULA_TRY(const Opened opened, open(path));
    return layoutOf(opened);
}

Result<RawImage> readNifti(const fs::path& path, Progress& progress, std::size_t volume) {
    MACULA_TRY(const Opened opened, open(path));
    MACULA_TRY(RawImageLayout layout, layoutOf(opened));
    MACULA_TRY_VOID(chooseVolume(layout, volume));
    MACULA_TRY(const ValuesInFile values, valuesOf(opened));
    const ValuesInFile chosen = valuesOfVolume(values, layout, volume);
    return readValues(std::move(layout), chosen, progress);
}

}  // namespace macula::formats
