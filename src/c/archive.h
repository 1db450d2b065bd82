// What a macula_archive is.
#pragma once

#include <macula.h>

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "c/handles.h"
#include "c/last_error.h"
#include "c/told_progress.h"
#include "net/archive/archive.h"

struct macula_archive {
    struct Refusal {
        std::string file;
        std::string why;
        std::string advice;
    };

    std::string name;
    std::unique_ptr<macula::net::Archive> archive;
    // What the last calls told the host.
    std::string json;
    std::string folder;
    std::vector<std::string> notes;
    std::vector<Refusal> refusals;
};

namespace macula::c {

inline std::string textOrEmpty(const char* text) {
    return text == nullptr ? std::string() : std::string(text);
}

// usage where it is none.
Result<void> checkUid(const char* uid);

// With U+FFFD for bytes that are not UTF-8: archives send them.
std::string jsonText(const nlohmann::ordered_json& json);

// Gives the host what `ask(archive, progress)` answers, which is a Result of JSON.
template <class Ask>
macula_status answer(macula_archive* archive, const macula_progress* progress, const char** json,
                     const Ask& ask) {
    if (json != nullptr) *json = nullptr;
    return guarded([&]() -> Result<void> {
        if (json == nullptr) return nullHandle();
        MACULA_TRY(const Held<macula_archive> of, changing(archive));
        return withProgress(progress, [&](Progress& to) -> Result<void> {
            MACULA_TRY(const auto answered, ask(*of->archive, to));
            of->json = jsonText(answered);
            *json = of->json.c_str();
            return {};
        });
    });
}

}  // namespace macula::c
