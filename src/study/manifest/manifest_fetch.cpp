#include "study/manifest/manifest_fetch.h"

#include <memory>
#include <set>
#include <utility>

#include "net/connect.h"
#include "study/manifest/manifest_source.h"

namespace macula::study {

namespace {

Text missingText(std::size_t missing, std::size_t named) {
    return Text("{} of {} images that the manifest names did not come.", missing, named);
}

// What came is read again from the disk: archives and manifests may disagree, and only files count.
Result<void> compare(const dicom::ManifestStudy& named, Spool& spool, Progress& progress,
                     FetchedStudy& fetched) {
    MACULA_TRY(const auto study, spool.study(named.studyInstanceUid, progress.token()));
    const std::set<std::string> there = study->instances();
    std::vector<std::string> missing;
    for (const dicom::ManifestSeries& series : named.series) {
        for (const dicom::ManifestInstance& instance : series.instances)
            if (!there.contains(instance.sopInstanceUid)) missing.push_back(instance.sopInstanceUid);
    }
    if (missing.empty()) return {};
    fetched.isComplete = false;
    fetched.messages.push_back(
        {Severity::warning,
         "manifest-names-more",
         {{"count", static_cast<std::int64_t>(missing.size())}},
         missingText(missing.size(), named.instances()),
         Text("Fetch the study again, or ask whoever made the manifest: images may have been removed, or "
              "lie elsewhere.")});
    MACULA_TRY(SpoolRecord record, readSpoolRecord(fetched.folder));
    record.isComplete = false;
    std::set<std::string> never(record.never.begin(), record.never.end());
    never.insert(missing.begin(), missing.end());
    record.never.assign(never.begin(), never.end());
    return study->finish(std::move(record));
}

Message leftOut(std::size_t references) {
    return {Severity::warning,
            "manifest-leaves-out",
            {{"count", static_cast<std::int64_t>(references)}},
            Text("{} references of the manifest have no valid UID, and were left out.", references),
            Text("Ask whoever made the manifest for a new one.")};
}

}  // namespace

Identity identityOf(const dicom::ImagingManifest& manifest) {
    return {.patientName = manifest.patientName,
            .patientId = manifest.patient.id,
            .birthDate = manifest.patient.birthDate,
            .sex = manifest.patient.sex,
            .studyDate = manifest.studyDate,
            .studyDescription = manifest.studyDescription,
            .series = {}};
}

Result<std::vector<FetchedStudy>> fetchManifest(const dicom::ImagingManifest& manifest,
                                                const net::SourceList& sources, const std::string& archive,
                                                Spool& spool, Progress& progress) {
    std::vector<net::Source> from;
    for (const dicom::ManifestStudy& study : manifest.studies) {
        MACULA_TRY(net::Source source, archive.empty() ? sourceOf(study, sources) : sources.find(archive));
        from.push_back(std::move(source));
    }
    std::vector<FetchedStudy> all;
    for (std::size_t i = 0; i < from.size(); ++i) {
        const dicom::ManifestStudy& named = manifest.studies[i];
        MACULA_TRY(const auto peer, net::archiveOf(sources, from[i]));
        FetchRequest request{.studyInstanceUid = named.studyInstanceUid, .chosen = identityOf(manifest)};
        request.chosen->studyInstanceUid = named.studyInstanceUid;
        MACULA_TRY(FetchedStudy fetched, fetchStudy(*peer, from[i].name, request, spool, progress));
        MACULA_TRY_VOID(compare(named, spool, progress, fetched));
        all.push_back(std::move(fetched));
    }
    if (manifest.unusable > 0 && !all.empty()) all.front().messages.push_back(leftOut(manifest.unusable));
    return all;
}

}  // namespace macula::study
