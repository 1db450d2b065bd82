#include "pipeline/splat/files/spz_records.h"

#include <cstring>

#include "base/check.h"
#include "pipeline/splat/model/turned_axes.h"

namespace macula::splat {

namespace {

constexpr std::size_t kRecordHeaderBytes = 8;

// "MA", the vendor, in the upper 16 bits, and 1, the kind of record, in the lower 16.
constexpr std::uint32_t kNotesType = 0x4d410001;
constexpr std::size_t kMostNotes = 4096;
constexpr std::uint32_t kCoordinateSystemType = 0xadbe0003;

std::uint32_t wordAt(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

}  // namespace

SpzRecords readSpzRecords(std::span<const std::byte> zone) {
    SpzRecords records;
    while (zone.size() >= kRecordHeaderBytes) {
        const std::uint32_t type = wordAt(zone, 0);
        const std::size_t length = wordAt(zone, 4);
        zone = zone.subspan(kRecordHeaderBytes);
        if (length > zone.size()) break;
        if (type == kNotesType && length <= kMostNotes)
            records.notes.assign(reinterpret_cast<const char*>(zone.data()), length);
        if (type == kCoordinateSystemType && length == sizeof(std::uint32_t)) records.axes = wordAt(zone, 0);
        zone = zone.subspan(length);
    }
    return records;
}

std::vector<std::byte> spzNotesRecord(const std::string& notes) {
    MACULA_CHECK_LE(notes.size(), kMostNotes);
    std::vector<std::byte> record(kRecordHeaderBytes + notes.size());
    const auto length = static_cast<std::uint32_t>(notes.size());
    std::memcpy(record.data(), &kNotesType, sizeof kNotesType);
    std::memcpy(record.data() + sizeof kNotesType, &length, sizeof length);
    std::memcpy(record.data() + kRecordHeaderBytes, notes.data(), notes.size());
    return record;
}

Result<void> heedSpzAxes(std::uint32_t axes, Splats& splats) {
    constexpr std::uint32_t kUnspecified = 0;
    constexpr std::uint32_t kRightUpBack = 4;
    constexpr std::uint32_t kLast = 16;
    if (axes > kLast) {
        return Error{ErrorCode::inputNotUsable,
                     Text("The SPZ file names axes (number {}) that this version does not know.", axes),
                     {},
                     Text("Convert it to one with the axes of the format (right, up, back), or to PLY.")};
    }
    if (axes == kUnspecified || axes == kRightUpBack) return {};
    const std::uint32_t bits = axes - 1;
    const double right = (bits & 1) != 0 ? 1.0 : -1.0;
    const double up = (bits & 2) != 0 ? 1.0 : -1.0;
    const bool isUpThird = (bits & 8) != 0;
    const double third = (bits & 4) != 0 ? 1.0 : -1.0;
    // Columns: the file's x, y and z, in the axes right, up, back that it means.
    glm::dmat3 meantFromFile(0.0);
    meantFromFile[0] = {right, 0.0, 0.0};
    if (isUpThird) {
        meantFromFile[1] = {0.0, 0.0, third};  // the third axis is front without the bit, back with it
        meantFromFile[2] = {0.0, up, 0.0};
    } else {
        meantFromFile[1] = {0.0, up, 0.0};
        meantFromFile[2] = {0.0, 0.0, -third};  // back without the bit, front with it
    }
    // The model is turned from the file by half a turn about x (spz.h).
    const glm::dmat3 modelFromMeant(glm::dvec3(1, 0, 0), glm::dvec3(0, -1, 0), glm::dvec3(0, 0, -1));
    turnAxes(splats, modelFromMeant * meantFromFile * glm::transpose(modelFromMeant));
    return {};
}

}  // namespace macula::splat
