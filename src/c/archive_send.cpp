// Files that a host stores in an archive.
#include <filesystem>
#include <vector>

#include "c/archive.h"
#include "c/sized.h"
#include "study/archive/files_to_send.h"

namespace macula::c {

namespace {

using Paths = std::vector<std::filesystem::path>;

Result<Paths> pathsOf(const char* const* paths, std::uint32_t count) {
    Paths all;
    for (std::uint32_t i = 0; paths != nullptr && i < count; ++i) {
        if (paths[i] == nullptr || *paths[i] == '\0') return nullHandle();
        all.emplace_back(paths[i]);
    }
    if (all.empty())
        return badArgument(Text("It is not said which files are sent."), Text("Give files or folders."));
    return all;
}

Result<void> send(macula_archive& archive, const Paths& paths, Progress& progress, macula_sent* told) {
    archive.refusals.clear();
    MACULA_TRY(const study::FilesToSend files, study::filesToSend(paths, progress));
    MACULA_TRY(const net::Sent sent, archive.archive->send(files.files, progress));
    for (const net::NotSent& each : sent.notSent)
        archive.refusals.push_back({each.file.string(), each.why.english(), each.advice.english()});
    macula_sent all{};
    all.files = files.files.size();
    all.stored = sent.stored;
    all.refused = sent.notSent.size();
    give(all, told);
    return {};
}

}  // namespace

extern "C" {

macula_status macula_archive_send(macula_archive* archive, const char* const* paths, std::uint32_t path_count,
                                  const macula_progress* progress, macula_sent* sent) {
    return guarded([&]() -> Result<void> {
        if (!isSized(sent)) return wrongSize(sent);
        MACULA_TRY(const Paths all, pathsOf(paths, path_count));
        MACULA_TRY(const Held<macula_archive> of, changing(archive));
        return withProgress(progress, [&](Progress& to) { return send(*of, all, to, sent); });
    });
}

macula_status macula_archive_refusal(const macula_archive* archive, std::uint32_t index,
                                     macula_refusal* refusal) {
    return guarded([&]() -> Result<void> {
        MACULA_TRY(const Held<const macula_archive> of, reading(archive));
        if (index >= of->refusals.size())
            return badArgument(Text("No file {} was refused.", index),
                               Text("There are {}.", of->refusals.size()));
        const macula_archive::Refusal& known = of->refusals[index];
        macula_refusal told{};
        told.file = known.file.c_str();
        told.why = known.why.c_str();
        told.advice = known.advice.c_str();
        return give(told, refusal) ? Result<void>() : wrongSize(refusal);
    });
}

}  // extern "C"

}  // namespace macula::c
