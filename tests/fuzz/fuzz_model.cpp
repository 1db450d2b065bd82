// Any bytes as a file of splats, in whatever format they look like: PLY, SPZ, glTF, or a training. Checksums
// are made right first, as otherwise nearly all that is changed would be found by them alone.
#include <algorithm>
#include <cstring>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "fuzz/file_of_bytes.h"
#include "pipeline/hybrid/model/peripheral_file.h"
#include "pipeline/splat/files/glb.h"
#include "pipeline/splat/files/gzip.h"
#include "pipeline/splat/files/model_file.h"
#include "pipeline/splat/files/ply.h"
#include "pipeline/splat/files/spz.h"
#include "pipeline/splat/files/training_file.h"

namespace macula::splat {
namespace {

constexpr std::size_t kFileHead = 16;  // see chunk_file.h
constexpr std::size_t kChunkHead = 40;
constexpr std::size_t kStoredBytes = 8;
constexpr std::size_t kCrc = 28;
constexpr std::size_t kHeadCrc = 32;

std::uint32_t checksumOf(const std::string& file, std::size_t from, std::size_t bytes) {
    return checksum(std::as_bytes(std::span(file)).subspan(from, bytes));
}

// Of every chunk that is whole.
void mendChecksums(std::string& file) {
    for (std::size_t at = kFileHead; file.size() >= at && file.size() - at >= kChunkHead;) {
        std::uint64_t stored = 0;
        std::memcpy(&stored, file.data() + at + kStoredBytes, sizeof stored);
        if (stored > file.size() - at - kChunkHead) return;
        const std::uint32_t crc = checksumOf(file, at + kChunkHead, stored);
        std::memcpy(file.data() + at + kCrc, &crc, sizeof crc);
        const std::uint32_t headCrc = checksumOf(file, at, kHeadCrc);
        std::memcpy(file.data() + at + kHeadCrc, &headCrc, sizeof headCrc);
        at += kChunkHead + stored;
    }
}

// SPZ of versions 1 to 3 lies in gzip; here it comes unpacked.
bool isUnpackedSpz(const std::string& file) {
    constexpr std::size_t kHeader = 16;
    return file.size() >= kHeader && file.starts_with("NGSP") && file[4] >= 1 && file[4] <= 3;
}

bool isSame(const Splats& a, const Splats& b) {
    return a.originMm == b.originMm && a.axes == b.axes && a.colourSpace == b.colourSpace &&
           a.lowPass == b.lowPass && a.shDegree == b.shDegree && a.position == b.position &&
           a.logScale == b.logScale && a.rotation == b.rotation && a.opacityLogit == b.opacityLogit &&
           a.dc == b.dc && a.sh == b.sh;
}

// What was read can be written in every format, and PLY is exact.
void write(const Splats& splats) {
    constexpr std::size_t kMostWritten = 300;
    if (splats.size() > kMostWritten) return;
    std::ostringstream ply;
    MACULA_CHECK(writePly(ply, splats).ok());
    const std::string text = std::move(ply).str();
    std::istringstream stream(text);
    const auto again = readPly(stream, text.size());
    MACULA_CHECK(again.ok() && isSame(again->splats, splats));
    for (const SpzVersion version : {SpzVersion::gzip, SpzVersion::zstd}) {
        const auto spz = encodeSpz(splats, version);
        if (spz) MACULA_CHECK(decodeSpz(spz->bytes, BadSplats::repairOrNone).ok());
    }
    std::ostringstream glb;
    if (!writeGlb(glb, splats)) return;
    const std::string bytes = std::move(glb).str();
    MACULA_CHECK(decodeGlb(std::as_bytes(std::span(bytes)), BadSplats::repairOrNone).ok());
}

void readModelOf(const std::filesystem::path& file) {
    for (const BadSplats bad : {BadSplats::refuse, BadSplats::repair, BadSplats::repairOrNone}) {
        const auto model = readModel(file, bad);
        if (!model) {
            MACULA_CHECK(!model.error().message.empty() && !model.error().hint.empty());
            continue;
        }
        MACULA_CHECK(model->splats.validate().ok());
        MACULA_CHECK(bad == BadSplats::repairOrNone || model->splats.size() > 0);
        if (bad == BadSplats::repair) write(model->splats);
    }
}

void readTrainingOf(const std::string& file) {
    std::istringstream stream(file);
    if (const auto state = readTraining(stream, file.size())) {
        MACULA_CHECK(state->validate().ok());
        std::ostringstream out;
        MACULA_CHECK(writeTraining(out, *state).ok());
    }
    std::istringstream again(file);
    if (const auto drawable = hybrid::readDrawable(again, file.size()))
        MACULA_CHECK(drawable->splats && drawable->splats->validate().ok());
    std::istringstream last(file);
    const auto peripheral = hybrid::readPeripheral(last, file.size());
    if (peripheral && !peripheral->isTrainingOnly) MACULA_CHECK(peripheral->state.validate().ok());
}

}  // namespace
}  // namespace macula::splat

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace macula::splat;
    std::string file(reinterpret_cast<const char*>(data), size);
    if (isUnpackedSpz(file)) {
        const auto packed = gzip(std::as_bytes(std::span(file)), "");
        MACULA_CHECK(packed.ok());
        file.assign(reinterpret_cast<const char*>(packed->data()), packed->size());
    }
    const bool isTraining = looksLikeTraining(std::string_view(file).substr(0, kChunkFileMagic.size()));
    if (isTraining) mendChecksums(file);
    readModelOf(
        macula::fuzz::fileOf(reinterpret_cast<const std::uint8_t*>(file.data()), file.size(), "model"));
    if (isTraining) readTrainingOf(file);
    return 0;
}
