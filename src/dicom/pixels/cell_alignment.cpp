#include "dicom/pixels/cell_alignment.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "dicom/pixels/pixels.h"

namespace macula::dicom {

namespace {

// If at most one in this many images is suspect, only decoding checks it (cellsBeyondStoredBits).
constexpr std::size_t kFewOf = 10;
constexpr std::size_t kMostLookedAt = 9;  // images of one format

bool hasRoomBelow(const CellFormat& format) {
    return isNarrow(format) && format.highBit + 1 > format.bitsStored;
}

void lookAt(const Frame& frame, const SliceIntensity& intensity, CellAlignment& alignment,
            const CancelToken& cancel) {
    const Instance& instance = *frame.instance;
    auto reader = PixelReader::open(instance.file,
                                    {.transferSyntaxUid = instance.transferSyntaxUid,
                                     .columns = instance.columns,
                                     .rows = instance.rows,
                                     .frames = instance.frames,
                                     .format = intensity.format},
                                    cancel);
    if (!reader) return;
    std::vector<std::uint16_t> cells(static_cast<std::size_t>(instance.columns) *
                                     static_cast<std::size_t>(instance.rows));
    if (reader->read(frame.number, cells)) alignment.add(cells, intensity.padding);
}

}  // namespace

CellAlignment::CellAlignment(const CellFormat& declared, std::uint16_t overlays)
    : declared_(declared),
      low_(((1u << (declared.highBit + 1 - declared.bitsStored)) - 1u) & ~unsigned{overlays}),
      overlays_(overlays) {}

CellFormat CellAlignment::atTheLowEnd() const {
    CellFormat format = declared_;
    format.highBit = format.bitsStored - 1;
    return format;
}

void CellAlignment::add(std::span<const std::uint16_t> cells, const std::optional<RawRange>& padding) {
    for (const std::uint16_t cell : cells) {
        const int whole = declared_.isSigned ? static_cast<std::int16_t>(cell) : static_cast<int>(cell);
        if (cell == 0 || (padding && padding->contains(whole))) continue;
        ++cells_;
        patterns_.insert(cell & low_);
        for (std::size_t bit = 0; bit < set_.size(); ++bit) set_[bit] += cell >> bit & 1u;
    }
    beyond_ += cellsBeyondStoredBits(atTheLowEnd(), padding, cells, overlays_);
}

bool CellAlignment::isAtTheLowEnd() const {
    if (low_ == 0 || cells_ == 0 || beyond_ > 0) return false;
    constexpr std::size_t kBusy = 20;  // at least one cell in this many has the bit, and one lacks it
    std::size_t all = 1;
    for (std::size_t bit = 0; bit < set_.size(); ++bit) {
        if ((low_ >> bit & 1u) == 0) continue;
        all *= 2;
        if (kBusy * set_[bit] < cells_ || kBusy * (cells_ - set_[bit]) < cells_) return false;
    }
    constexpr std::size_t kEnough = 64;  // few pixels cannot show all of 256 patterns
    return patterns_.size() > std::min(all / 2, kEnough);
}

std::size_t alignCells(const Stack& stack, std::span<SliceIntensity> intensities, const CancelToken& cancel) {
    std::vector<std::size_t> suspects;
    for (std::size_t f = 0; f < intensities.size(); ++f) {
        if (hasRoomBelow(intensities[f].format)) suspects.push_back(f);
    }
    if (suspects.empty() || kFewOf * suspects.size() <= intensities.size()) return 0;
    std::vector<std::pair<CellAlignment, std::vector<std::size_t>>> formats;  // and the frames that have them
    for (const std::size_t f : suspects) {
        const auto known = std::ranges::find_if(
            formats, [&](const auto& entry) { return entry.first.declared() == intensities[f].format; });
        if (known != formats.end()) {
            known->second.push_back(f);
        } else {
            const std::uint16_t overlays = stack.frames[f].instance->overlayBits;
            formats.emplace_back(CellAlignment(intensities[f].format, overlays), std::vector{f});
        }
    }
    std::size_t count = 0;
    for (auto& [alignment, frames] : formats) {
        const std::size_t looks = std::min(kMostLookedAt, frames.size());
        for (std::size_t n = 0; n < looks && !cancel.cancelled(); ++n) {
            const std::size_t f = frames[n * (frames.size() - 1) / std::max<std::size_t>(1, looks - 1)];
            lookAt(stack.frames[f], intensities[f], alignment, cancel);
        }
        if (!alignment.isAtTheLowEnd()) continue;
        for (const std::size_t f : frames) intensities[f].format = alignment.atTheLowEnd();
        count += frames.size();
    }
    return count;
}

}  // namespace macula::dicom
