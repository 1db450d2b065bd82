#include "study/open/scanned_place.h"

#include <utility>

#include "study/open/found_volumes.h"
#include "unpack/archive_name.h"
#include "unpack/unpacked_archive.h"

namespace macula::study {

namespace {

Message messageOf(const char* key, Severity severity, std::size_t count, Text sentence, Text action) {
    return {.severity = severity,
            .key = key,
            .arguments = {{"count", static_cast<std::int64_t>(count)}},
            .sentence = std::move(sentence),
            .action = std::move(action)};
}

void tellFacts(std::vector<Message>& messages, const unpack::ArchiveFacts& facts) {
    const auto tell = [&](const char* key, Severity severity, std::size_t count, Text sentence, Text action) {
        if (count > 0)
            messages.push_back(messageOf(key, severity, count, std::move(sentence), std::move(action)));
    };
    if (facts.isCutOff)
        tell(key::kArchiveCutOff, Severity::warning, facts.files,
             Text("The archive is cut off or damaged: what follows its first {} files is lost.", facts.files),
             Text("Get the archive again; images may be missing."));
    tell(key::kArchiveEncrypted, Severity::warning, facts.encrypted,
         Text("Files in the archive that are encrypted, and were left out: {}.", facts.encrypted),
         Text("Unpack it with another program, which asks for the password, and open the folder."));
    tell(key::kArchiveDamaged, Severity::warning, facts.damaged,
         Text("Files in the archive that are damaged, or packed in a way that Macula does not know, and were "
              "left "
              "out: {}.",
              facts.damaged),
         Text("Get the archive again; images may be missing."));
    tell(key::kArchiveLinks, Severity::info, facts.links,
         Text("Links and devices in the archive, which were left out: {}.", facts.links), Text());
    tell(key::kArchiveOutside, Severity::info, facts.outside,
         Text("Files whose names lead out of the archive, and which were unpacked like the others: {}.",
              facts.outside),
         Text());
}

Result<ScannedPlace> scanArchive(const std::filesystem::path& archive, Progress& progress,
                                 const dicom::ScanOptions& options) {
    ScannedPlace place;
    MACULA_TRY(place.copy, unpack::unpack(archive, progress));
    Result<dicom::Scan> scan = dicom::scanFolder(place.copy->folder(), progress, options);
    if (!scan && scan.error().code == ErrorCode::inputNotUsable)
        return Error{ErrorCode::inputNotUsable, Text("The archive was unpacked. {}", scan.error().message),
                     archive.string(), scan.error().hint};
    if (!scan) return scan.error();
    place.scan = *std::move(scan);
    tellFacts(place.scan.messages, place.copy->facts());
    for (dicom::SkippedFile& skipped : place.scan.skipped)
        skipped.file = archive / skipped.file.lexically_relative(place.copy->folder());
    return place;
}

// The copy goes last.
struct FoundInCopy {
    explicit FoundInCopy(ScannedPlace place) : copy(std::move(place.copy)), found(std::move(place.scan)) {}

    std::shared_ptr<const unpack::UnpackedArchive> copy;
    FoundVolumes found;
};

}  // namespace

Result<ScannedPlace> scanPlace(const std::filesystem::path& path, Progress& progress,
                               const dicom::ScanOptions& options) {
    if (unpack::isArchive(path)) return scanArchive(path, progress, options);
    ScannedPlace place;
    MACULA_TRY(place.scan, dicom::scanFolder(path, progress, options));
    return place;
}

std::shared_ptr<const FoundVolumes> foundVolumesOf(ScannedPlace place) {
    auto held = std::make_shared<const FoundInCopy>(std::move(place));
    return {held, &held->found};
}

}  // namespace macula::study
