// What belongs to the library itself: its version, its names, its log, and handles that cancel.
#include <macula.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/log.h"
#include "c/last_error.h"
#include "c/told_progress.h"
#include "pipeline/trace/look.h"
#include "scene/choice/built_in_list.h"

namespace macula::c {

namespace {

template <class Named>
std::vector<std::string> namesOf(const std::vector<Named>& all) {
    std::vector<std::string> names;
    for (const Named& one : all) names.push_back(one.name);
    return names;
}

// By kind: MACULA_PRESETS and so on.
std::vector<std::vector<std::string>> allNames() {
    const Result<scene::BuiltIns> all = scene::builtIns();
    MACULA_CHECK(all.ok());  // they are part of the library
    std::vector<std::string> looks;
    for (const trace::LookTraits& look : trace::kLooks) looks.emplace_back(look.name);
    return {namesOf(all->presets), namesOf(all->clips), namesOf(all->lights), looks, namesOf(all->qualities)};
}

std::string builtInText() {
    const Result<scene::BuiltIns> all = scene::builtIns();
    MACULA_CHECK(all.ok());  // they are part of the library
    return toJson(*all).dump(4);
}

std::int32_t levelOf(log::Level level) {
    switch (level) {
        case log::Level::debug:
            return MACULA_LOG_DEBUG;
        case log::Level::info:
            return MACULA_LOG_INFO;
        case log::Level::warning:
            return MACULA_LOG_WARNING;
        case log::Level::error:
        case log::Level::off:
            break;
    }
    return MACULA_LOG_ERROR;
}

void toNobody(log::Level /*level*/, std::string_view /*line*/) {}

}  // namespace

void silenceLog() noexcept {
    static std::once_flag once;
    try {
        std::call_once(once, [] {
            // A host in C++ may have a sink of its own already.
            if (std::getenv("MACULA_LOG") == nullptr && !log::hasSink()) log::setSink(toNobody);
        });
    } catch (const std::exception&) {
        // Without memory there will be other errors.
    }
}

extern "C" {

macula_status macula_log_to(macula_log_line told, void* user, std::int32_t least) {
    return guarded([&]() -> Result<void> {
        constexpr std::array kLevels{log::Level::debug, log::Level::info, log::Level::warning,
                                     log::Level::error};
        if (least < 0 || std::size_t(least) >= kLevels.size())
            return badArgument(Text("There is no such level of the log."),
                               Text("Use MACULA_LOG_DEBUG to MACULA_LOG_ERROR."));
        if (told == nullptr) {
            log::setSink(toNobody);
            return {};
        }
        log::setLevel(kLevels.at(std::size_t(least)));
        log::setSink([told, user](log::Level level, std::string_view line) {
            told(user, levelOf(level), std::string(line).c_str());
        });
        return {};
    });
}

const char* macula_version() {
    return MACULA_VERSION;
}

macula_status macula_cancel_create(macula_cancel** cancel) {
    if (cancel != nullptr) *cancel = nullptr;
    return guarded([&]() -> Result<void> {
        if (cancel == nullptr) return nullHandle();
        *cancel = std::make_unique<macula_cancel>().release();
        return {};
    });
}

void macula_cancel_now(macula_cancel* cancel) {
    if (cancel != nullptr) cancel->token.cancel();
}

void macula_cancel_close(macula_cancel* cancel) {
    delete cancel;
}

const char* macula_name(std::int32_t kind, std::uint32_t index) {
    const char* name = nullptr;
    guarded([&]() -> Result<void> {
        static const std::vector<std::vector<std::string>> names = allNames();
        if (kind < 0 || std::size_t(kind) >= names.size()) return {};
        const std::vector<std::string>& ofKind = names[std::size_t(kind)];
        if (index < ofKind.size()) name = ofKind[index].c_str();
        return {};
    });
    return name;
}

macula_status macula_built_in(const char** json) {
    if (json != nullptr) *json = nullptr;
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        static const std::string text = builtInText();
        *json = text.c_str();
        return {};
    });
}

}  // extern "C"

}  // namespace macula::c
