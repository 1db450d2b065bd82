#include "pipeline/splat/files/spz.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <limits>
#include <new>
#include <optional>
#include <sstream>
#include <string>

#include "pipeline/splat/files/gzip.h"
#include "pipeline/splat/files/model_notes.h"
#include "pipeline/splat/files/spz_codes.h"
#include "pipeline/splat/files/spz_container.h"
#include "pipeline/splat/files/spz_records.h"
#include "pipeline/splat/model/constant_colour.h"

namespace macula::splat {

namespace {

static_assert(std::endian::native == std::endian::little, "the header is written as it lies in memory");

constexpr std::uint32_t kMagic = 0x5053474e;  // "NGSP"
constexpr std::string_view kMagicText = "NGSP";
constexpr std::uint32_t kLastGzipVersion = 3;
constexpr std::uint32_t kContainerVersion = 4;
constexpr std::uint32_t kMostSplats = 10'000'000;
constexpr int kMostFractionalBits = 20;      // a millionth of a mm; float32 is no finer
constexpr int kMostFractionalBitsRead = 31;  // for models a few thousandths of a unit across
constexpr double kMostFixed = (1 << 23) - 1;
constexpr std::uint8_t kAntialiased = 1;
constexpr std::uint8_t kHasExtensions = 2;
constexpr std::size_t kMostExtensionBytes = std::size_t{1} << 24;

// Guards against decompression bombs: identical splats pack hundreds of times smaller, so a small file may
// claim millions of them. The unpacked size may be this many times the file, or a size that any machine has.
// Real models shrink by a factor below 15, even point clouds with bands of zeros.
constexpr std::uint64_t kMostPacking = 32;
constexpr std::uint64_t kAlwaysUnpacked = std::uint64_t{32} << 20;

struct Header {
    std::uint32_t magic = kMagic;
    std::uint32_t version = kContainerVersion;
    std::uint32_t count = 0;
    std::uint8_t shDegree = 0;
    std::uint8_t fractionalBits = 0;
    std::uint8_t flags = 0;
    std::uint8_t reserved = 0;

    std::size_t positionBytes() const { return version == 1 ? 2 : 3; }
    std::size_t rotationBytes() const { return version < 3 ? 3 : 4; }
    // The size of each attribute, in the order of the file.
    std::array<std::size_t, 6> streamBytes() const {
        const std::size_t n = count;
        return {3 * n * positionBytes(), n, 3 * n, 3 * n, n * rotationBytes(), 3 * n * shCount(shDegree)};
    }
    std::size_t bytes() const {
        std::size_t sum = 0;
        for (const std::size_t stream : streamBytes()) sum += stream;
        return sum;
    }
};
static_assert(sizeof(Header) == kSpzHeaderBytes);

// Signs by which the real spherical harmonics change when y and z change theirs.
constexpr std::array<float, 15> kTurn{-1, -1, 1, -1, 1, 1, -1, 1, -1, 1, -1, -1, 1, -1, 1};

glm::vec3 turned(const glm::vec3& v) {
    return {v.x, -v.y, -v.z};
}

// Turns a quaternion in the order w, x, y, z.
glm::vec4 turned(const glm::vec4& q) {
    return {q[0], q[1], -q[2], -q[3]};
}

Error unusable(Text message, Text hint = Text("Get the file again from where it came.")) {
    return {ErrorCode::inputNotUsable, std::move(message), {}, std::move(hint)};
}

Error damaged() {
    return unusable(Text("The SPZ file is cut off or damaged."));
}

Result<int> fractionalBits(const Splats& splats) {
    double farthest = 0.0;
    for (const glm::vec3& p : splats.position) {
        for (int axis = 0; axis < 3; ++axis)
            farthest = std::max(farthest, std::abs(static_cast<double>(p[axis])));
    }
    for (int bits = kMostFractionalBits; bits >= 0; --bits) {
        if (std::round(std::ldexp(farthest, bits)) <= kMostFixed) return bits;
    }
    return unusable(Text("The model reaches farther than an SPZ file can say: 8 km from its origin."),
                    Text("Remove the splats that are so far away, or write a PLY."));
}

// The constant coefficient as the file stores it: of a display colour.
glm::vec3 displayed(const Splats& splats, std::size_t i) {
    glm::vec3 dc = splats.dc[i];
    if (splats.colourSpace == ColourSpace::display) return dc;
    for (int c = 0; c < 3; ++c) dc[c] = dcOfColour(spz::encoded(colourOfDc(dc[c])));
    return dc;
}

// The factor of the higher coefficients. Derived from the byte of the constant one, so that a reader divides
// by the same.
float slopeOf(std::uint8_t colourByte, ColourSpace space) {
    if (space == ColourSpace::display) return 1.0f;
    return spz::slope(spz::linearOf(colourOfDc(spz::dcOf(colourByte))));
}

void toLinear(Splats& splats) {
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t i = 0; i < splats.size(); ++i) {
        for (int c = 0; c < 3; ++c) {
            const float linear = spz::linearOf(colourOfDc(splats.dc[i][c]));
            splats.dc[i][c] = dcOfColour(linear);
            for (std::size_t k = 0; k < count; ++k) splats.sh[i * count + k][c] /= spz::slope(linear);
        }
    }
}

// Reads bytes from the front.
class Reader {
  public:
    explicit Reader(const std::vector<std::uint8_t>& bytes) : next_(bytes.data()) {}
    std::uint8_t byte() { return *next_++; }
    std::uint32_t bytes(std::size_t count) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < count; ++i) value |= std::uint32_t{byte()} << (8 * i);
        return value;
    }

  private:
    const std::uint8_t* next_;
};

float position(Reader& in, const Header& header) {
    if (header.version == 1) return glm::unpackHalf1x16(static_cast<std::uint16_t>(in.bytes(2)));
    // The sign is in the 24th bit.
    const auto fixed = static_cast<std::int32_t>(in.bytes(3) << 8) >> 8;
    return static_cast<float>(std::ldexp(static_cast<double>(fixed), -header.fractionalBits));
}

Splats splatsOf(const Header& header, const std::vector<std::uint8_t>& bytes) {
    Splats splats;
    splats.shDegree = header.shDegree;
    splats.resize(header.count);
    Reader in(bytes);
    for (glm::vec3& p : splats.position) {
        for (int axis = 0; axis < 3; ++axis) p[axis] = position(in, header);
        p = turned(p);
    }
    for (float& logit : splats.opacityLogit) logit = spz::opacityLogit(in.byte());
    for (glm::vec3& dc : splats.dc) {
        for (int c = 0; c < 3; ++c) dc[c] = spz::dcOf(in.byte());
    }
    for (glm::vec3& scale : splats.logScale) {
        for (int axis = 0; axis < 3; ++axis) scale[axis] = spz::logScale(in.byte());
    }
    for (glm::vec4& rotation : splats.rotation) {
        if (header.rotationBytes() == 4) {
            rotation = turned(spz::rotationOf(in.bytes(4)));
            continue;
        }
        const std::uint8_t x = in.byte();
        const std::uint8_t y = in.byte();
        rotation = turned(spz::rotationOf(x, y, in.byte()));
    }
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t i = 0; i < splats.sh.size(); ++i) {
        for (int c = 0; c < 3; ++c) splats.sh[i][c] = kTurn[i % count] * spz::shOf(in.byte());
    }
    return splats;
}

bool mayBeUnpacked(std::uint64_t bytes, std::uint64_t packedBytes) {
    return bytes <= std::max(kAlwaysUnpacked, kMostPacking * packedBytes);
}

Result<void> check(const Header& header, std::size_t packedBytes) {
    if (header.magic != kMagic)
        return unusable(Text("The file is gzip, but no SPZ model is in it."),
                        Text("Choose a model of Gaussians."));
    if (header.version < 1 || header.version > kContainerVersion)
        return unusable(
            Text("The SPZ file has version {}; 1 to {} are read.", header.version, kContainerVersion),
            Text("Convert it to version 4, or to PLY."));
    if (header.shDegree > kMaxShDegree)
        return unusable(Text("The SPZ file has spherical harmonics of degree {}; 0 to {} are read.",
                             header.shDegree, kMaxShDegree),
                        Text("Export it with a lower degree."));
    if (header.version > 1 && header.fractionalBits > kMostFractionalBitsRead) return damaged();
    if (header.count > kMostSplats)
        return unusable(
            Text("The SPZ file counts {} splats; no more than {} are read.", header.count, kMostSplats),
            Text("Convert it to PLY, of which there is no such limit."));
    if (!mayBeUnpacked(header.bytes(), packedBytes))
        return unusable(Text("The SPZ file counts {} splats, for which it is too small.", header.count));
    return {};
}

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string commentOf(const Splats& splats) {
    std::string text = "In this file x, y, z of the model are x, -y, -z";
    if (splats.colourSpace == ColourSpace::linear) text += ", and its linear colours are sRGB-encoded";
    for (const std::string& note : notesOf(splats)) text += "\n" + note;
    return text;
}

// All bytes after the header, in the order of the file.
std::vector<std::uint8_t> payload(const Splats& splats, const Header& header, std::size_t& clamped) {
    std::vector<std::uint8_t> out;
    out.reserve(header.bytes());
    const auto add = [&](std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    std::vector<bool> held(splats.size(), true);
    const auto note = [&](std::size_t i, bool is) { held[i] = held[i] && is; };

    for (const glm::vec3& p : splats.position) {
        const glm::vec3 at = turned(p);
        for (int axis = 0; axis < 3; ++axis)
            add(static_cast<std::uint32_t>(
                    std::lround(std::ldexp(static_cast<double>(at[axis]), header.fractionalBits))),
                3);
    }
    for (const float logit : splats.opacityLogit) out.push_back(spz::alphaByte(logit));
    std::vector<glm::vec3> slopes(splats.size());
    for (std::size_t i = 0; i < splats.size(); ++i) {
        const glm::vec3 dc = displayed(splats, i);
        bool is = true;
        for (int c = 0; c < 3; ++c) {
            out.push_back(spz::colourByte(dc[c], is));
            slopes[i][c] = slopeOf(out.back(), splats.colourSpace);
        }
        note(i, is);
    }
    for (std::size_t i = 0; i < splats.size(); ++i) {
        bool is = true;
        for (int axis = 0; axis < 3; ++axis) out.push_back(spz::scaleByte(splats.logScale[i][axis], is));
        note(i, is);
    }
    for (const glm::vec4& rotation : splats.rotation) add(spz::rotationBits(turned(rotation)), 4);
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t i = 0; i < splats.sh.size(); ++i) {
        const glm::vec3 sh = kTurn[i % count] * slopes[i / count] * splats.sh[i];
        bool is = true;
        for (int c = 0; c < 3; ++c) out.push_back(spz::shByte(sh[c], is));
        note(i / count, is);
    }
    clamped = static_cast<std::size_t>(std::count(held.begin(), held.end(), false));
    return out;
}

}  // namespace

Result<SpzBytes> encodeSpz(const Splats& splats, SpzVersion version) {
    MACULA_TRY_VOID(splats.validate());
    if (splats.size() == 0) return unusable(Text("The model holds no splats."), Text("Train it first."));
    if (splats.size() > kMostSplats)
        return unusable(
            Text("The model has {} splats; an SPZ file holds at most {}.", splats.size(), kMostSplats),
            Text("Write a PLY."));
    MACULA_TRY(const int bits, fractionalBits(splats));
    const bool zstd = version == SpzVersion::zstd;
    const Header header{.version = zstd ? kContainerVersion : kLastGzipVersion,
                        .count = static_cast<std::uint32_t>(splats.size()),
                        .shDegree = static_cast<std::uint8_t>(splats.shDegree),
                        .fractionalBits = static_cast<std::uint8_t>(bits),
                        .flags = splats.lowPass == LowPass::classic ? std::uint8_t{0} : kAntialiased};
    const auto headerBytes = std::bit_cast<std::array<std::byte, kSpzHeaderBytes>>(header);
    SpzBytes file;
    std::vector<std::uint8_t> data = payload(splats, header, file.clamped);
    if (zstd) {
        MACULA_TRY(file.bytes, packSpzStreams(headerBytes, commentOf(splats), std::as_bytes(std::span(data)),
                                              header.streamBytes()));
    } else {
        const auto* begin = reinterpret_cast<const std::uint8_t*>(headerBytes.data());
        data.insert(data.begin(), begin, begin + headerBytes.size());
        MACULA_TRY(file.bytes, gzip(std::as_bytes(std::span(data)), commentOf(splats)));
    }
    if (!mayBeUnpacked(header.bytes(), file.bytes.size()))
        return unusable(
            Text(
                "The model's splats are so much alike that its SPZ file could not be told from a false one."),
            Text("Write a PLY."));
    return file;
}

namespace {

Result<ModelFile> finished(const Header& header, const std::vector<std::uint8_t>& data,
                           const std::string& notes, std::optional<std::uint32_t> axes, BadSplats bad) {
    Splats splats = splatsOf(header, data);
    if (axes) MACULA_TRY_VOID(heedSpzAxes(*axes, splats));
    MACULA_TRY_VOID(applyNotes(linesOf(notes), splats));
    const bool antialiased = (header.flags & kAntialiased) != 0;
    if (!antialiased) splats.lowPass = LowPass::classic;
    if (antialiased && splats.lowPass == LowPass::classic) splats.lowPass = LowPass::compensated;
    if (splats.colourSpace == ColourSpace::linear) toLinear(splats);
    return finishModel(std::move(splats), bad);
}

Result<ModelFile> decodeContainer(std::span<const std::byte> bytes, BadSplats bad) {
    Header header;
    if (bytes.size() < sizeof header) return damaged();
    std::memcpy(&header, bytes.data(), sizeof header);
    MACULA_TRY_VOID(check(header, bytes.size()));
    if (header.version != kContainerVersion) return damaged();  // earlier versions are gzip streams
    std::vector<std::uint8_t> data(header.bytes());
    SpzRecords records;
    if (!unpackSpzStreams(bytes, header.streamBytes(), std::as_writable_bytes(std::span(data)), records))
        return damaged();
    return finished(header, data, records.notes, records.axes, bad);
}

Result<ModelFile> decodeGzip(std::span<const std::byte> bytes, BadSplats bad) {
    Gunzip packed(bytes);
    Header header;
    if (!packed.read(std::as_writable_bytes(std::span(&header, 1)))) return damaged();
    MACULA_TRY_VOID(check(header, bytes.size()));
    if (header.version > kLastGzipVersion) return damaged();
    std::vector<std::uint8_t> data(header.bytes());
    const std::size_t most = (header.flags & kHasExtensions) != 0 ? kMostExtensionBytes : 0;
    if (!packed.read(std::as_writable_bytes(std::span(data)))) return damaged();
    const auto behind = packed.rest(most);
    if (!behind) return damaged();
    return finished(header, data, packed.headerComment(), readSpzRecords(*behind).axes, bad);
}

}  // namespace

Result<ModelFile> decodeSpz(std::span<const std::byte> bytes, BadSplats bad) {
    if (bytes.size() > std::numeric_limits<std::uint32_t>::max())
        return unusable(Text("The file is larger than any SPZ model."),
                        Text("Check that it is the file you meant."));
    const bool container = bytes.size() >= kMagicText.size() &&
                           std::memcmp(bytes.data(), kMagicText.data(), kMagicText.size()) == 0;
    try {
        return container ? decodeContainer(bytes, bad) : decodeGzip(bytes, bad);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::outOfMemory,
                     Text("The model does not fit into memory."),
                     {},
                     Text("Close other programs, or export a smaller one.")};
    }
}

bool looksLikeSpz(std::string_view begin) {
    return begin.starts_with("\x1f\x8b") || begin == kMagicText;
}

}  // namespace macula::splat
