#include "nifti_bytes.h"

#include <zlib.h>

#include <cmath>
#include <fstream>

namespace macula::formats::test {

namespace {

const glm::dmat4 kFlip(-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

}  // namespace

glm::ivec3 NiftiBytes::size() const {
    return {get<std::int16_t>(42), get<std::int16_t>(44), get<std::int16_t>(46)};
}

glm::dmat4 NiftiBytes::sform() const {
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 4; ++column)
            m[column][row] = get<float>(std::size_t(280 + 16 * row + 4 * column));
    }
    return kFlip * m;
}

// nifti1.h, "METHOD 2".
glm::dmat4 NiftiBytes::qform() const {
    const double b = get<float>(256), c = get<float>(260), d = get<float>(264);
    const double a = std::sqrt(std::max(0.0, 1.0 - (b * b + c * c + d * d)));
    const double rows[3][3] = {{a * a + b * b - c * c - d * d, 2 * b * c - 2 * a * d, 2 * b * d + 2 * a * c},
                               {2 * b * c + 2 * a * d, a * a + c * c - b * b - d * d, 2 * c * d - 2 * a * b},
                               {2 * b * d - 2 * a * c, 2 * c * d + 2 * a * b, a * a + d * d - c * c - b * b}};
    const double scale[3] = {get<float>(80), get<float>(84),
                             get<float>(88) * (get<float>(76) < 0 ? -1.0 : 1.0)};
    glm::dmat4 m(1.0);
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) m[column][row] = rows[row][column] * scale[column];
        m[3][row] = get<float>(std::size_t(268 + 4 * row));
    }
    return kFlip * m;
}

double NiftiBytes::value(int i, int j, int k) const {
    const std::size_t n =
        (std::size_t(k) * std::size_t(size().y) + std::size_t(j)) * std::size_t(size().x) + std::size_t(i);
    const auto start = static_cast<std::size_t>(get<float>(108));
    const double slope = get<float>(112) != 0.0f ? get<float>(112) : 1.0;
    const double intercept = get<float>(112) != 0.0f ? get<float>(116) : 0.0;
    double raw = NAN;
    if (datatype() == 4) raw = get<std::int16_t>(start + 2 * n);
    if (datatype() == 512) raw = get<std::uint16_t>(start + 2 * n);
    if (datatype() == 16) raw = get<float>(start + 4 * n);
    return slope * raw + intercept;
}

NiftiBytes readNiftiBytes(const std::filesystem::path& path) {
    NiftiBytes file;
    const gzFile stream = gzopen(path.c_str(), "rb");
    if (stream == nullptr) return file;
    std::vector<char> buffer(1 << 20);
    for (int got = gzread(stream, buffer.data(), 1 << 20); got > 0;
         got = gzread(stream, buffer.data(), 1 << 20))
        file.bytes.append(buffer.data(), std::size_t(got));
    gzclose(stream);
    return file;
}

void writeBytes(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::remove(path);  // ext4 flushes a file that is emptied and written anew
    std::ofstream(path, std::ios::binary) << bytes;
}

std::string gzipped(const std::string& bytes) {
    z_stream stream{};
    deflateInit2(&stream, 6, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, bytes.size()), '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

NiftiBytes makeNifti(std::int16_t datatype, int bytesPerVoxel) {
    NiftiBytes file;
    file.bytes.assign(352 + std::size_t(3 * 4 * 5 * bytesPerVoxel), '\0');
    file.set<std::int32_t>(0, 348);
    const std::array<std::int16_t, 8> dim{3, 3, 4, 5, 1, 1, 1, 1};
    for (std::size_t n = 0; n < dim.size(); ++n) file.set(40 + 2 * n, dim[n]);
    file.set(70, datatype);
    file.set<std::int16_t>(72, static_cast<std::int16_t>(8 * bytesPerVoxel));
    for (std::size_t n = 0; n < 4; ++n) file.set(76 + 4 * n, n == 0 ? 1.0f : float(n));
    file.set(108, 352.0f);
    file.set<char>(123, 2);
    file.set<std::int16_t>(254, 1);
    file.set(280, 1.0f);
    file.set(300, 2.0f);
    file.set(320, 3.0f);
    file.bytes.replace(344, 3, "n+1");
    return file;
}

}  // namespace macula::formats::test
