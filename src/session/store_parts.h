// The parts of a Store, each with a source of its own. Their contracts are those of Store. Private to
// src/session.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "session/store.h"
#include "session/store_state.h"

namespace macula::session {

// The studies and series, and when they were opened.
class StoreStudies {
  public:
    explicit StoreStudies(StoreState& state) : state_(state) {}

    Result<void> recordOpened(const OpenedVolume& opened);
    Result<Listing<StudyEntry>> list();
    Result<Listing<SeriesEntry>> listSeries(const std::string& study);

  private:
    StoreState& state_;
};

class StoreModels {
  public:
    explicit StoreModels(StoreState& state) : state_(state) {}

    Result<SaveReport> save(const ModelKey& key, std::span<const std::byte> blob);
    Result<std::optional<ModelInfo>> find(const ModelKey& key);
    Result<std::vector<ModelCandidate>> nearest(const ModelKey& key, std::size_t most);
    Result<LoadedModel> read(const ModelInfo& info);
    Result<std::filesystem::path> fileOf(const ModelInfo& info) const;
    Result<void> setAside(const ModelInfo& info, std::string_view why);
    Result<Listing<ModelInfo>> list(const std::string& volume);
    Result<void> touch(const ModelKey& key);
    Result<OpenMark> markOpen(const ModelKey& key);
    Result<EvictionReport> evict(std::uint64_t capBytes);

  private:
    StoreState& state_;
};

class StoreDocuments {
  public:
    explicit StoreDocuments(StoreState& state) : state_(state) {}

    Result<void> change(const DocumentId& id, std::int64_t version, const Store::DocumentEdit& edit,
                        std::span<const std::string_view> known);
    Result<std::optional<Document>> get(const DocumentId& id);
    Result<Listing<DocumentEntry>> list(DocumentKind kind, const std::string& study);
    Result<bool> remove(const DocumentId& id);

  private:
    StoreState& state_;
};

// Deletes data for good.
class StorePurge {
  public:
    explicit StorePurge(StoreState& state) : state_(state) {}

    Result<PurgeReport> study(const std::string& study, DamagedFiles damaged);
    Result<PurgeReport> volume(const std::string& volume, DamagedFiles damaged);
    Result<PurgeReport> unused(std::chrono::days retention, DamagedFiles damaged, Store::Clock clock);
    Result<PurgeReport> all(DamagedFiles damaged);
    Result<ClockDoubt> clockDoubt(std::chrono::days retention);

  private:
    StoreState& state_;
};

// Verification and garbage collection.
class StoreCare {
  public:
    explicit StoreCare(StoreState& state) : state_(state) {}

    Result<VerifyReport> verify(Progress& progress);
    Result<GcReport> collectGarbage();

  private:
    StoreState& state_;
};

// Export and import.
class StoreSnapshots {
  public:
    explicit StoreSnapshots(StoreState& state) : state_(state) {}

    Result<SnapshotReport> exportTo(const std::filesystem::path& newFolder, Progress& progress);
    Result<SnapshotReport> importFrom(const std::filesystem::path& folder, Progress& progress);

  private:
    StoreState& state_;
};

// Within a transaction, call addAuditRow instead.
class AuditTrail {
  public:
    explicit AuditTrail(StoreState& state) : state_(state) {}

    Result<void> add(AuditAction action, AuditKind kind, const std::string& subject, std::int64_t amount);
    Result<Listing<AuditEntry>> list(std::size_t most);

  private:
    StoreState& state_;
};

}  // namespace macula::session
