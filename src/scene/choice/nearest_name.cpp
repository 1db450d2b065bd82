#include "scene/choice/nearest_name.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace macula::scene {

namespace {

// The number of letters to insert, delete or replace (Levenshtein).
std::size_t changesBetween(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i + 1;
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({row[j] + 1, row[j + 1] + 1, changed});
        }
    }
    return row.back();
}

}  // namespace

std::string nearestName(std::string_view typed, const std::vector<std::string>& names) {
    std::string nearest;
    std::size_t fewest = (typed.size() + 2) / 3 + 1;
    for (const std::string& name : names) {
        const std::size_t changes = changesBetween(typed, name);
        if (changes < fewest) {
            fewest = changes;
            nearest = name;
        }
    }
    return nearest;
}

Text choiceAmong(std::string_view typed, const std::vector<std::string>& names) {
    const std::string nearest = nearestName(typed, names);
    return Text::joined({nearest.empty() ? Text() : Text("Did you mean {}?", nearest),
                         Text("There are: {}.", fmt::format("{}", fmt::join(names, ", ")))},
                        " ");
}

Error noSuchName(Text sentence, const std::string& typed, const std::vector<std::string>& names,
                 const Text& orElse) {
    return {ErrorCode::usage, std::move(sentence), typed,
            Text::joined({choiceAmong(typed, names), orElse}, " ")};
}

}  // namespace macula::scene
