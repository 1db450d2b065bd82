#include "net/sources/source_list.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>
#include <thread>
#include <utility>

#include "base/atomic_file.h"
#include "base/file_lock.h"
#include "base/parsing.h"
#include "base/private_file.h"
#include "base/user_folder.h"
#include "net/sources/source_json.h"

namespace macula::net {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::milliseconds kLockIsTriedEvery{20};
// A service may take the time of an answer twice.
constexpr std::chrono::minutes kPatienceWithRenewal{3};

Error othersSignIn() {
    return {ErrorCode::archiveNotUsable,
            Text("Another program is renewing the sign-in at this archive, and does not end."),
            {},
            Text("Close other windows of Macula, then try again.")};
}

fs::path managedFile() {
    const char* folders = std::getenv("XDG_CONFIG_DIRS");
    std::istringstream list(folders != nullptr && *folders != '\0' ? folders : "/etc/xdg");
    for (std::string folder; std::getline(list, folder, ':');) {
        fs::path file = fs::path(folder) / "macula" / "sources.json";
        std::error_code failure;
        if (file.is_absolute() && fs::exists(file, failure)) return file;
    }
    return "/etc/xdg/macula/sources.json";
}

Result<std::vector<Source>> readSources(const fs::path& file) {
    std::error_code failure;
    if (!fs::exists(file, failure)) return std::vector<Source>();
    MACULA_TRY(const std::string text, readText(file));
    auto sources = sourcesFromJson(text);
    if (sources) return sources;
    Error error = sources.error();
    error.code = ErrorCode::inputNotUsable;
    error.where = file.string();
    return error;
}

// Nobody else may read it, not even for a moment: the folder is private before the file is there.
Result<void> writePrivately(const fs::path& file, const nlohmann::json& json) {
    std::error_code failure;
    const bool isNew = fs::create_directories(file.parent_path(), failure);
    if (failure)
        return Error{ErrorCode::outputNotWritable,
                     Text("The folder for the list of archives cannot be made."), file.string(),
                     Text("Check the permissions of your data folder.")};
    if (isNew) fs::permissions(file.parent_path(), fs::perms::owner_all, failure);
    return writeTextPrivately(file, json.dump(2) + "\n");
}

Result<nlohmann::json> readSecrets(const fs::path& file) {
    struct stat state {};
    if (stat(file.c_str(), &state) != 0) return nlohmann::json::object();
    if ((state.st_mode & (S_IRWXG | S_IRWXO)) != 0)
        return Error{ErrorCode::inputNotUsable,
                     Text("Others can read the file with the passwords of archives."), file.string(),
                     Text("Run chmod 600 on it, and change the passwords if others use this machine.")};
    MACULA_TRY(const std::string text, readText(file));
    nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object())
        return Error{ErrorCode::inputNotUsable, Text("The file with the passwords of archives is damaged."),
                     file.string(), Text("Remove it, and enter the passwords again.")};
    return json;
}

std::string namesOf(const std::vector<Source>& sources) {
    std::string names;
    for (const Source& source : sources) names += (names.empty() ? "" : ", ") + source.name;
    return names;
}

auto named(std::vector<Source>& sources, std::string_view name) {
    return std::find_if(sources.begin(), sources.end(),
                        [&](const Source& source) { return source.name == name; });
}

}  // namespace

SourceFiles SourceFiles::ofUser() {
    const fs::path folder = userDataFolder();
    return {.managed = managedFile(), .own = folder / "sources.json", .secrets = folder / "secrets.json"};
}

Result<SourceList> SourceList::read(SourceFiles files) {
    SourceList list(std::move(files));
    MACULA_TRY_VOID(list.readAgain());
    return list;
}

Result<void> SourceList::readAgain() {
    MACULA_TRY(all_, readSources(files_.managed));
    for (Source& source : all_) source.isManaged = true;
    MACULA_TRY(own_, readSources(files_.own));
    for (const Source& source : own_) {
        if (named(all_, source.name) == all_.end()) all_.push_back(source);
    }
    return {};
}

Result<Source> SourceList::find(std::string_view name) const {
    std::vector<Source> fitting;
    for (const Source& source : all_) {
        if (source.name == name) return source;
        if (lowerCase(source.name) == lowerCase(std::string(name))) fitting.push_back(source);
    }
    if (fitting.size() == 1) return fitting.front();
    if (all_.empty())
        return Error{ErrorCode::usage,
                     Text("No archive has been set up."),
                     {},
                     Text("Set one up with macula pacs add.")};
    return Error{ErrorCode::usage,
                 Text("There is no archive of that name."),
                 {},
                 Text("These are there: {}.", namesOf(all_))};
}

Result<void> SourceList::refuseManaged(std::string_view name) const {
    const auto found =
        std::find_if(all_.begin(), all_.end(), [&](const Source& source) { return source.name == name; });
    if (found == all_.end() || !found->isManaged) return {};
    return Error{ErrorCode::usage,
                 Text("The administrator has set up this archive; it cannot be changed here."),
                 {},
                 Text("Ask your administrator, or choose another name.")};
}

Result<void> SourceList::put(const Source& source) {
    MACULA_TRY_VOID(checkSource(source));
    MACULA_TRY_VOID(readAgain());
    MACULA_TRY_VOID(refuseManaged(source.name));
    if (const auto before = named(own_, source.name); before != own_.end()) {
        *before = source;
    } else {
        own_.push_back(source);
    }
    MACULA_TRY_VOID(writePrivately(files_.own, toJson(own_)));
    return readAgain();
}

Result<void> SourceList::remove(std::string_view name) {
    MACULA_TRY_VOID(readAgain());
    MACULA_TRY(const Source source, find(name));
    MACULA_TRY_VOID(refuseManaged(source.name));
    MACULA_TRY_VOID(keep(source, {}));
    own_.erase(named(own_, source.name));
    MACULA_TRY_VOID(writePrivately(files_.own, toJson(own_)));
    return readAgain();
}

Result<Secrets> SourceList::secretsOf(const Source& source) const {
    MACULA_TRY(const nlohmann::json all, readSecrets(files_.secrets));
    const auto entry = all.find(source.name);
    Secrets secrets;
    if (entry == all.end() || !entry->is_object()) return secrets;
    const auto read = [&](const char* name, std::string& value) {
        const auto member = entry->find(name);
        if (member != entry->end() && member->is_string()) value = *member;
    };
    read("password", secrets.password);
    read("token", secrets.token);
    read("refreshToken", secrets.refreshToken);
    read("keyPassphrase", secrets.keyPassphrase);
    return secrets;
}

Result<void> SourceList::keep(const Source& source, const Secrets& secrets) {
    MACULA_TRY(nlohmann::json all, readSecrets(files_.secrets));
    nlohmann::json entry = nlohmann::json::object();
    if (!secrets.password.empty()) entry["password"] = secrets.password;
    if (!secrets.token.empty()) entry["token"] = secrets.token;
    if (!secrets.refreshToken.empty()) entry["refreshToken"] = secrets.refreshToken;
    if (!secrets.keyPassphrase.empty()) entry["keyPassphrase"] = secrets.keyPassphrase;
    if (entry.empty() && !all.contains(source.name)) return {};
    if (entry.empty()) {
        all.erase(source.name);
    } else {
        all[source.name] = std::move(entry);
    }
    return writePrivately(files_.secrets, all);
}

Result<Secrets> SourceList::renewTokens(const Source& source, const Secrets& ours,
                                        const std::string& readBefore, const AskForTokens& ask,
                                        const CancelToken& cancel) const {
    // A lock of another thread of this program keeps this one out too.
    const FileLock lock(fs::path(files_.secrets).concat(".lock"));
    const auto until = std::chrono::steady_clock::now() + kPatienceWithRenewal;
    while (lock.isThere() && !lock.isOurs()) {
        if (cancel.cancelled())
            return Error{ErrorCode::cancelled, Text("The sign-in was cancelled."), {}, {}};
        if (std::chrono::steady_clock::now() >= until) return othersSignIn();
        std::this_thread::sleep_for(kLockIsTriedEvery);
    }
    auto kept = secretsOf(source);
    const bool isRenewed = kept && !kept->token.empty() && !kept->refreshToken.empty() &&
                           kept->refreshToken != readBefore && kept->refreshToken != ours.refreshToken;
    if (isRenewed) return kept;
    MACULA_TRY(Secrets renewed, ask(ours));
    // Where they cannot be kept, the caller still has them: the person signs in again another day.
    static_cast<void>(keepTokens(source, renewed));
    return renewed;
}

Result<void> SourceList::keepTokens(const Source& source, const Secrets& secrets) const {
    MACULA_TRY(nlohmann::json all, readSecrets(files_.secrets));
    const auto entry = all.find(source.name);
    if (entry == all.end() || !entry->is_object()) return {};
    (*entry)["token"] = secrets.token;
    (*entry)["refreshToken"] = secrets.refreshToken;
    return writePrivately(files_.secrets, all);
}

}  // namespace macula::net
