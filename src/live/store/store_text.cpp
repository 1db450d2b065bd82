#include "live/store/store_text.h"

#include <fmt/format.h>

#include <string_view>

#include "base/printable.h"
#include "live/store/byte_size.h"
#include "live/store/time_text.h"

namespace macula::live {

namespace {

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
    return fmt::format("{} {}", count, count == 1 ? one : many);
}

std::string studies(std::size_t count) {
    return counted(count, "study", "studies");
}
std::string models(std::size_t count) {
    return counted(count, "model", "models");
}
std::string states(std::size_t count) {
    return counted(count, "stored state", "stored states");
}

std::string models(std::size_t count, std::uint64_t bytes) {
    return count == 0 ? models(0) : fmt::format("{} ({})", models(count), sizeForPeople(bytes));
}

// The text after two blanks, or nothing.
std::string readable(const std::optional<std::string>& text) {
    return text ? "  " + printable(*text) : std::string();
}

std::string unreadable(std::size_t count) {
    if (count == 0) return {};
    return fmt::format("{} cannot be read, and {} left out: see macula sessions verify.\n",
                       counted(count, "entry", "entries"), count == 1 ? "is" : "are");
}

std::string lineOf(const session::ModelInfo& model) {
    std::string text =
        fmt::format("    of volume {}, trainer {}", shortOf(model.key.volume), model.key.trainer);
    for (const session::KeyPart& part : model.key.parts)
        text += fmt::format(", {} {}", part.name, shortOf(part.digest));
    text += fmt::format("\n      {}, saved {}, used {}{}\n", sizeForPeople(model.bytes),
                        localTime(model.savedMs), localTime(model.usedMs),
                        model.aside.empty() ? "" : ", set aside as damaged (" + model.aside + ")");
    return text;
}

std::string lineOf(const session::SeriesEntry& series) {
    std::string text = fmt::format("    {}  {}{}\n", shortOf(series.identity), localTime(series.lastOpenedMs),
                                   readable(series.readable));
    for (const std::string& volume : series.volumes)
        text += fmt::format("      volume {}\n", shortOf(volume));
    return text;
}

std::string whatGoes(const PurgePlan& plan) {
    return fmt::format("{}, {} and {}", studies(plan.studies.size()),
                       models(plan.models.models, plan.models.bytes), states(plan.documents));
}

// What the plan cannot count.
std::string_view uncounted(const PurgePlan& plan) {
    return plan.request.unusedDays ? ", and models of files without a study that were not opened either" : "";
}

Text sentencesOf(session::ClockDoubt doubt) {
    const Error error = keptForClock(doubt);
    return Text::joined({error.message, error.hint}, " ");
}

}  // namespace

std::string nothingStoredText(const std::filesystem::path& folder) {
    return fmt::format("Nothing is stored yet in {}.\n", printable(folder.string()));
}

std::string textOf(const StoredStudies& stored) {
    std::string text;
    for (const session::StudyEntry& study : stored.studies.entries)
        text += fmt::format("{}  {}  {:<20}  {:<16}{}\n", shortOf(study.identity),
                            localTime(study.lastOpenedMs), models(study.models, study.modelBytes),
                            states(study.documents), readable(study.readable));
    text += unreadable(stored.studies.damaged);
    text += fmt::format("{} and {} in {}.\n", studies(stored.studies.entries.size()),
                        models(stored.models.models, stored.models.bytes), printable(stored.folder.string()));
    if (stored.withoutStudy.models > 0)
        text += fmt::format("Of these {} of files that belong to no study.\n",
                            models(stored.withoutStudy.models, stored.withoutStudy.bytes));
    if (stored.modelsAside > 0)
        text +=
            fmt::format("Besides, {} set aside as damaged: macula sessions gc --cap removes such first.\n",
                        models(stored.modelsAside));
    return text;
}

std::string textOf(const StoredStudy& stored) {
    const session::StudyEntry& study = stored.study;
    std::string text =
        fmt::format("Study {}{}\n  first opened {}\n  last opened  {}\n", study.identity,
                    readable(study.readable), localTime(study.firstOpenedMs), localTime(study.lastOpenedMs));
    text += fmt::format("  {} series\n", stored.series.entries.size());
    for (const session::SeriesEntry& series : stored.series.entries) text += lineOf(series);
    text += fmt::format("  {}\n", models(stored.models.entries.size()));
    for (const session::ModelInfo& model : stored.models.entries) text += lineOf(model);
    text += fmt::format("  {}\n", states(stored.documents.entries.size()));
    for (const session::DocumentEntry& document : stored.documents.entries)
        text += fmt::format("    {}  {}  version {}  changed {}\n", session::nameOf(document.id.kind),
                            printable(document.id.name), document.version, localTime(document.changedMs));
    return text + unreadable(stored.series.damaged + stored.models.damaged + stored.documents.damaged);
}

std::string textOf(const VerifiedStore& verified) {
    const session::VerifyReport& report = verified.report;
    std::string text =
        fmt::format("Read {} and {}: {}.\n", counted(report.rows, "row", "rows"), models(report.blobs),
                    verified.isSound() ? "all is sound" : "not all is sound");
    if (report.damagedRows > 0)
        text += fmt::format("Damaged: {}.\n", counted(report.damagedRows, "row", "rows"));
    if (report.damagedBlobs > 0)
        text += fmt::format("Damaged or missing: {}.\n", models(report.damagedBlobs));
    if (report.setAside > 0)
        text += fmt::format("Set aside, now and before, and used no more: {}.\n",
                            counted(report.setAside, "model or stored state", "models and stored states"));
    if (report.orphans > 0)
        text += fmt::format("Left over: {}; macula sessions gc removes them.\n",
                            counted(report.orphans, "file", "files"));
    if (report.damagedFolders > 0)
        text +=
            fmt::format("Kept: {} of damaged files; macula sessions purge with --damaged-too deletes them.\n",
                        counted(report.damagedFolders, "folder", "folders"));
    return text;
}

std::string whatToDo(const VerifiedStore& verified) {
    const session::VerifyReport& report = verified.report;
    if (verified.isRescuePending)
        return "Close all windows of Macula and verify once more: what can be read is rescued then.";
    if (!report.isDatabaseSound)
        return "Copy what can be read with macula sessions export and import, into another --folder, and use "
               "that one.";
    if (verified.notes.setAside)
        return "Nothing has to be done: what could be read is in a new file, and the damaged one is kept.";
    return "Nothing has to be done: models are learnt anew, and studies written anew when they are opened.";
}

std::string textOf(const Tidied& tidied) {
    return fmt::format(
        "Removed {} and {}. {} of models are left.\n", models(tidied.evicted.models, tidied.evicted.bytes),
        tidied.leftOvers.blobs == 0
            ? std::string("no left-overs")
            : fmt::format("{} ({})", counted(tidied.leftOvers.blobs, "left-over", "left-overs"),
                          sizeForPeople(tidied.leftOvers.bytes)),
        sizeForPeople(tidied.evicted.bytesLeft));
}

std::string textOf(const session::SnapshotReport& copied) {
    std::string text = fmt::format("Copied {}, {} and {}.\n", studies(copied.studies), models(copied.models),
                                   states(copied.documents));
    if (copied.skipped > 0)
        text += fmt::format("Left out: {}, for which what is stored here is as new, or which have no room.\n",
                            counted(copied.skipped, "model or stored state", "models and stored states"));
    if (copied.damaged > 0)
        text += fmt::format("Left out as damaged: {}.\n", counted(copied.damaged, "entry", "entries"));
    return text;
}

std::string textOf(const PurgePlan& plan) {
    std::string text = fmt::format("Would delete {}{}.\n", whatGoes(plan), uncounted(plan));
    for (const session::StudyEntry& study : plan.studies)
        text += fmt::format("  {}  {}{}\n", shortOf(study.identity), localTime(study.lastOpenedMs),
                            readable(study.readable));
    if (plan.clock != session::ClockDoubt::none) text += sentencesOf(plan.clock).english() + "\n";
    return text;
}

std::string questionOf(const PurgePlan& plan) {
    const std::string which =
        plan.studies.size() == 1 ? " (" + shortOf(plan.studies.front().identity) + ")" : std::string();
    return fmt::format("Delete {}{}{}? Nobody can bring them back.", whatGoes(plan), which, uncounted(plan));
}

std::string textOf(const session::PurgeReport& purged) {
    return fmt::format("Deleted {}, {}, {} and {}.\n", studies(purged.studies),
                       counted(purged.volumes, "volume", "volumes"), models(purged.models),
                       states(purged.documents));
}

std::vector<Text> warningsOf(const session::PurgeReport& purged) {
    std::vector<Text> warnings;
    if (purged.skippedOpen > 0)
        warnings.push_back(Text(
            "{} left, because models of theirs are open. Close other windows of "
            "Macula and purge once more.",
            purged.skippedOpen == 1 ? Text("1 study was") : Text("{} studies were", purged.skippedOpen)));
    if (purged.damagedFolders > 0)
        warnings.push_back(
            Text("{} of damaged files may hold parts of what was deleted; "
                 "--damaged-too deletes them as well.",
                 purged.damagedFolders == 1 ? Text("1 folder") : Text("{} folders", purged.damagedFolders)));
    if (purged.clock != session::ClockDoubt::none) warnings.push_back(sentencesOf(purged.clock));
    return warnings;
}

std::string textOf(const session::Listing<session::AuditEntry>& trail) {
    std::string text;
    for (const session::AuditEntry& entry : trail.entries)
        text += fmt::format("{}  {:<9} {:<9} {:<12}  {}\n", localTime(entry.atMs), printable(entry.action),
                            printable(entry.kind), shortOf(entry.subject), entry.amount);
    if (trail.entries.empty()) text += "The audit trail is empty.\n";
    return text + unreadable(trail.damaged);
}

std::vector<Text> warningsOf(const session::OpeningNotes& notes) {
    std::vector<Text> warnings;
    if (const auto& aside = notes.setAside)
        warnings.push_back(Text(
            "The file of stored sessions was damaged. {}, among them {} and {}, were rescued; the damaged "
            "file is kept in {}.",
            aside->rowsRescued == 1 ? Text("1 row") : Text("{} rows", aside->rowsRescued),
            aside->modelsRescued == 1 ? Text("1 model") : Text("{} models", aside->modelsRescued),
            aside->documentsRescued == 1 ? Text("1 stored state")
                                         : Text("{} stored states", aside->documentsRescued),
            printable(aside->folder.string())));
    if (notes.versionBefore > 0)
        warnings.push_back(Text(
            "Stored sessions were brought to the format of this version; older ones cannot read them now."));
    if (notes.othersMayRead)
        warnings.push_back(Text("Other users of this computer may be able to read stored sessions."));
    return warnings;
}

}  // namespace macula::live
