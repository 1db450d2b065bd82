// What is of the library itself: its version, its names, and handles that cancel.
#include <macula.h>

#include <memory>
#include <string>
#include <vector>

#include "app/choice/built_in_list.h"
#include "c/last_error.h"
#include "c/told_progress.h"
#include "pipeline/trace/look.h"

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
    const Result<app::BuiltIns> all = app::builtIns();
    MACULA_CHECK(all.ok());  // they are part of the library
    std::vector<std::string> looks;
    for (const trace::LookTraits& look : trace::kLooks) looks.emplace_back(look.name);
    return {namesOf(all->presets), namesOf(all->clips), namesOf(all->lights), looks, namesOf(all->qualities)};
}

}  // namespace

extern "C" {

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

}  // extern "C"

}  // namespace macula::c
