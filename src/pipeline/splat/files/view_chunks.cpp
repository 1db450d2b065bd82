#include "pipeline/splat/files/view_chunks.h"

#include <cstring>
#include <memory>
#include <utility>

namespace macula::splat {

namespace {

// A view in the file: its RasterView, kind, weight and last loss.
struct ViewRecord {
    double cameraFromWorld[9];  // column by column
    double eyeMm[3];
    double focalPx[2];
    double principalPx[2];
    double nearMm;
    double loss;
    double l1;
    std::int32_t sizePx[2];
    float weight;
    ViewKind kind;
};
static_assert(sizeof(ViewRecord) == kViewRecordBytes);

ViewRecord recordOf(const TrainingState::View& view) {
    const RasterView& v = view.given->view;
    ViewRecord record{.nearMm = v.nearMm,
                      .loss = view.loss,
                      .l1 = view.l1,
                      .weight = view.given->weight,
                      .kind = view.given->kind};
    for (int i = 0; i < 9; ++i) record.cameraFromWorld[i] = v.cameraFromWorld[i / 3][i % 3];
    for (int i = 0; i < 3; ++i) record.eyeMm[i] = v.eyeMm[i];
    for (int i = 0; i < 2; ++i) {
        record.focalPx[i] = v.focalPx[i];
        record.principalPx[i] = v.principalPx[i];
        record.sizePx[i] = v.sizePx[i];
    }
    return record;
}

RasterView viewOf(const ViewRecord& record) {
    RasterView v{.nearMm = record.nearMm};
    for (int i = 0; i < 9; ++i) v.cameraFromWorld[i / 3][i % 3] = record.cameraFromWorld[i];
    for (int i = 0; i < 3; ++i) v.eyeMm[i] = record.eyeMm[i];
    for (int i = 0; i < 2; ++i) {
        v.focalPx[i] = record.focalPx[i];
        v.principalPx[i] = record.principalPx[i];
        v.sizePx[i] = record.sizePx[i];
    }
    return v;
}

// The view without its pixels.
Result<TrainingView> emptyViewOf(const ViewRecord& record) {
    TrainingView view{.view = viewOf(record), .weight = record.weight, .kind = record.kind};
    if (!validate(view.view).ok() || record.kind > ViewKind::standIn) return damagedModel();
    return view;
}

}  // namespace

std::vector<std::byte> viewRecords(std::span<const TrainingState::View> views) {
    std::vector<std::byte> bytes(views.size() * sizeof(ViewRecord));
    for (std::size_t i = 0; i < views.size(); ++i) {
        const ViewRecord record = recordOf(views[i]);
        std::memcpy(&bytes[i * sizeof(record)], &record, sizeof(record));
    }
    return bytes;
}

// Reads the chunks of pixels one by one, and then unpacks them in parallel.
Result<std::vector<TrainingState::View>> readViews(ChunkFile& file, const ViewChunkNames& names,
                                                   std::uint64_t count) {
    std::vector<const ChunkEntry*> entries;
    for (const ChunkEntry& entry : file.entries()) {
        if (entry.name == names.pixels) entries.push_back(&entry);
    }
    if (entries.size() != count || count > kMostViews) return damagedModel();
    MACULA_TRY(const std::vector<ViewRecord> records, file.readArray<ViewRecord>(names.records, count));
    std::vector<Result<std::vector<std::byte>>> bytes;
    std::vector<TrainingView> given;
    std::uint64_t total = 0;
    for (std::size_t i = 0; i < count; ++i) {
        MACULA_TRY(TrainingView view, emptyViewOf(records[i]));
        const auto pixels =
            static_cast<std::uint64_t>(view.view.sizePx.x) * static_cast<std::uint64_t>(view.view.sizePx.y);
        if (entries[i]->plainBytes != pixels * kPixelBytes) return damagedModel();
        total += entries[i]->plainBytes;
        bytes.push_back(file.stored(*entries[i]));
        if (!bytes.back().ok()) return bytes.back().error();
        given.push_back(std::move(view));
    }
    forEachChunk(count, total, [&](std::size_t i) {
        bytes[i] = ChunkFile::unpacked(*entries[i], std::move(bytes[i]).value());
        if (!bytes[i].ok()) return;
        given[i].pixels.resize(bytes[i]->size() / kPixelBytes);
        std::memcpy(given[i].pixels.data(), bytes[i]->data(), bytes[i]->size());
        bytes[i] = std::vector<std::byte>{};
    });
    std::vector<TrainingState::View> views;
    for (std::size_t i = 0; i < count; ++i) {
        if (!bytes[i].ok()) return bytes[i].error();
        views.push_back({.given = std::make_shared<const TrainingView>(std::move(given[i])),
                         .loss = records[i].loss,
                         .l1 = records[i].l1});
    }
    return views;
}

}  // namespace macula::splat
