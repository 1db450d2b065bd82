// Archives that really run, as a host reaches them through the C interface.
#pragma once

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "c/c_fixture.h"
#include "net/servers.h"
#include "synthetic.h"

namespace macula::test {

// As docs/pacs.md describes one that speaks DIMSE.
inline nlohmann::json dimseAt(std::uint16_t port, const std::string& title) {
    return {{"name", "Hospital"}, {"dimse", {{"host", "127.0.0.1"}, {"port", port}, {"calledAe", title}}}};
}

inline nlohmann::json webAt(const std::string& url) {
    return {{"name", "Cloud"}, {"dicomweb", {{"url", url}}}};
}

inline Owned<macula_archive> archiveOf(const nlohmann::json& source) {
    macula_archive* made = nullptr;
    EXPECT_EQ(macula_archive_of_json(source.dump().c_str(), nullptr, &made), MACULA_DONE)
        << lastError().message;
    return Owned<macula_archive>(made);
}

// What a call answers.
template <class Ask>
nlohmann::json answered(const Ask& ask) {
    const char* json = nullptr;
    EXPECT_EQ(ask(&json), MACULA_DONE) << lastError().message << lastError().advice;
    return nlohmann::json::parse(json == nullptr ? "" : json, nullptr, false);
}

// Two series of a study.
struct SentStudy {
    dicom::test::TemporaryFolder folder;
    std::string uid;
    std::vector<std::string> series;
    std::vector<std::filesystem::path> files;
    int slices = 0;  // of each series

    explicit SentStudy(std::string studyUid = "2.25.9100", int slicesOfSeries = 6, int side = 16)
        : uid(std::move(studyUid)), slices(slicesOfSeries) {
        for (int i = 1; i <= 2; ++i) {
            dicom::test::SyntheticSeries written;
            written.studyUid = uid;
            written.seriesUid = uid + "." + std::to_string(i);
            written.frameOfReferenceUid = uid + ".9";
            written.number = i;
            written.size = {side, side, slices};
            written.ramp.emplace().perMm = {0.5, 0.25, 1.0};  // its values fit however large it is
            const std::filesystem::path own = folder / std::to_string(i);
            std::filesystem::create_directory(own);
            for (const auto& file : dicom::test::writeFiles(own, written)) files.push_back(file);
            series.push_back(written.seriesUid);
        }
    }

    void sendTo(macula_archive* archive) const {
        const std::string path = folder.path().string();
        const char* const paths[]{path.c_str()};
        auto sent = sized<macula_sent>();
        ASSERT_EQ(macula_archive_send(archive, paths, 1, nullptr, &sent), MACULA_DONE)
            << lastError().message << lastError().advice;
        EXPECT_EQ(sent.files, files.size());
        EXPECT_EQ(sent.stored, files.size());
        EXPECT_EQ(sent.refused, 0u);
    }
};

inline std::vector<std::string> datasetsIn(const std::vector<std::filesystem::path>& files) {
    std::vector<std::string> datasets;
    for (const auto& file : files) datasets.push_back(net::test::datasetBytes(file));
    std::ranges::sort(datasets);
    return datasets;
}

inline std::vector<std::filesystem::path> filesIn(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    return files;
}

// A fetch into a folder of the test, and what a host hears of it.
class Fetching {
  public:
    explicit Fetching(const SentStudy& study) : study_(study) {
        fetch.study_uid = study_.uid.c_str();
        fetch.into = into_.c_str();
        fetch.arrived = hearArrival;
        fetch.user = this;
        progress.told = hearProgress;
        progress.user = this;
    }
    virtual ~Fetching() = default;
    Fetching(const Fetching&) = delete;
    Fetching& operator=(const Fetching&) = delete;

    macula_status from(macula_archive* archive) {
        return macula_archive_fetch(archive, &fetch, &progress, &fetched);
    }
    const SentStudy& study() const { return study_; }

    macula_fetch fetch = sized<macula_fetch>();
    macula_progress progress = sized<macula_progress>();
    macula_fetched fetched = sized<macula_fetched>();
    // What was heard last.
    std::string folder;
    std::uint64_t instances = 0;
    std::uint64_t bytes = 0;
    int arrivals = 0;
    int stages = 0;

  protected:
    // Whether the host goes on.
    virtual bool hears() { return true; }
    virtual bool hearsProgress() { return true; }

  private:
    // A host hears of one thing at a time.
    struct Alone {
        std::atomic<bool>& isHearing;
        explicit Alone(std::atomic<bool>& hearing) : isHearing(hearing) {
            EXPECT_FALSE(isHearing.exchange(true)) << "two calls at once";
        }
        ~Alone() { isHearing = false; }
    };
    static std::int32_t hearArrival(void* user, const char* folder, std::uint64_t instances,
                                    std::uint64_t bytes) {
        auto& me = *static_cast<Fetching*>(user);
        const Alone alone(me.isHearing_);
        EXPECT_GT(instances, me.instances);
        me.folder = folder;
        me.instances = instances;
        me.bytes = bytes;
        ++me.arrivals;
        return me.hears() ? 0 : 1;
    }
    static std::int32_t hearProgress(void* user, const char* stage, double fraction) {
        auto& me = *static_cast<Fetching*>(user);
        const Alone alone(me.isHearing_);
        EXPECT_STRNE(stage, "");
        EXPECT_GE(fraction, 0.0);
        EXPECT_LE(fraction, 1.0);
        ++me.stages;
        return me.hearsProgress() ? 0 : 1;
    }

    const SentStudy& study_;
    dicom::test::TemporaryFolder place_;
    std::string into_ = (place_ / "fetched").string();
    std::atomic<bool> isHearing_{false};
};

inline std::vector<std::string> notesOf(const macula_archive* archive) {
    std::vector<std::string> notes;
    while (const char* note = macula_archive_note(archive, std::uint32_t(notes.size())))
        notes.emplace_back(note);
    return notes;
}

}  // namespace macula::test
