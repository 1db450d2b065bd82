#include "pages/commands.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>

#include "cli/run_command.h"

namespace macula::test {
namespace {

using Words = std::vector<std::string>;

Words splitAt(std::string_view text, char separator) {
    Words parts;
    std::istringstream stream{std::string(text)};
    for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
    return parts;
}

Words wordsIn(std::string_view text) {
    Words words;
    std::istringstream stream{std::string(text)};
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

struct Help {
    std::set<std::string> verbs;
    std::map<std::string, Words> options;  // to the values that may be chosen, where they are few
    std::set<std::string> required;
};

// Of "  --look cinematic|clear|dvr" and of what follows "Subcommands:".
// `verb` begins with the program.
Help readHelp(const Words& verb) {
    Words call(verb.begin() + 1, verb.end());
    call.emplace_back("--help");
    Help help;
    const auto program = verb.front() == "macula" ? cli::TestedProgram::macula : cli::TestedProgram::bench;
    std::istringstream lines(cli::run(program, call).out);
    bool areVerbs = false;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(" ")) areVerbs = line.starts_with("Subcommands:");
        if (!line.starts_with("  ") || line.starts_with("   ")) continue;
        const Words words = wordsIn(line);
        if (areVerbs) help.verbs.insert(words[0]);
        if (!words[0].starts_with("-")) continue;
        const bool isRequired = std::ranges::find(words, "REQUIRED") != words.end();
        for (const std::string& name : splitAt(words[0], ',')) {
            const std::string option = name.substr(0, name.find('{'));
            const bool isChoice = words.size() > 1 && words[1].find('|') != std::string::npos;
            help.options[option] = isChoice ? splitAt(words[1], '|') : Words{};
        }
        if (isRequired) help.required.insert(words[0]);
    }
    return help;
}

const Help& helpOf(const Words& verb) {
    static std::map<Words, Help> known;
    const auto found = known.find(verb);
    return found != known.end() ? found->second : known.emplace(verb, readHelp(verb)).first->second;
}

std::string inLowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

// What `macula presets` lists, by the option in the headings: numbers and names of --preset, names of the
// others.
std::map<std::string, std::set<std::string>> readBuiltIn() {
    std::map<std::string, std::set<std::string>> builtIn;
    std::string option;
    std::istringstream lines(cli::runMacula({"presets"}).out);
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with(" ")) {
            const std::size_t open = line.find("(--");
            option = open == std::string::npos
                         ? ""
                         : line.substr(open + 1, line.find_first_of(" )", open) - open - 1);
            continue;
        }
        const Words words = wordsIn(line);
        for (std::size_t i = 0; i < std::min<std::size_t>(words.size(), option == "--preset" ? 2 : 1); ++i)
            builtIn[option].insert(words[i]);
    }
    return builtIn;
}

// NAME, WxH, CT.xml, a.xml#CT-Mine, ..., -
bool isPlaceholder(const std::string& word) {
    return word.find_first_of(".#/") != std::string::npos || word.find("…") != std::string::npos ||
           word.find_first_of("abcdefghijklmnopqrstuvwxyz0123456789") == std::string::npos;
}

std::string whyUnknown(const std::string& option, const std::string& value) {
    static const auto builtIn = readBuiltIn();
    const auto names = builtIn.find(option);
    if (names == builtIn.end() || isPlaceholder(value) || names->second.contains(inLowerCase(value)))
        return {};
    return value + " is no " + option.substr(2) + " of `macula presets`";
}

std::string whyWrong(const std::string& option, const std::string& value, const Help& help) {
    const auto known = help.options.find(option);
    if (known == help.options.end()) return "there is no option " + option;
    const Words& choices = known->second;
    if (!choices.empty() && !isPlaceholder(value) && std::ranges::find(choices, value) == choices.end())
        return value + " is no " + option;
    return whyUnknown(option, value);
}

}  // namespace

std::vector<std::string> maculaWords(std::string_view line) {
    std::string bare(line.substr(0, line.find(" #")));
    std::erase_if(bare, [](char c) { return c == '[' || c == ']'; });
    Words words = wordsIn(bare);
    const auto nameOf = [](const std::string& word) { return word.substr(word.rfind('/') + 1); };
    const auto isProgram = [&](const std::string& word) {
        return nameOf(word) == "macula" || nameOf(word) == "macula-bench";
    };
    const auto isBefore = [](const std::string& word) {
        return word == "xvfb-run" || word.find('=') < word.size();
    };
    auto program = words.begin();
    while (program != words.end() && isBefore(*program)) ++program;
    if (program == words.end() || !isProgram(*program)) return {};
    *program = nameOf(*program);
    return {program, words.end()};
}

const std::set<std::string>& verbsBehind(const std::vector<std::string>& verb) {
    return helpOf(verb).verbs;
}

std::string whyRefused(const std::vector<std::string>& words, bool isWhole) {
    if (words.empty()) return "it calls no program of ours";
    Words verb{words.front()};
    std::size_t at = 1;
    for (; at < words.size() && helpOf(verb).verbs.contains(words[at]); ++at) verb.push_back(words[at]);
    const Help& help = helpOf(verb);
    const bool mayBeAlone = verb == Words{"macula", "presets"} || !isWhole;
    if (!help.verbs.empty() && at < words.size() && !words[at].starts_with("-") && !isPlaceholder(words[at]))
        return "there is no verb " + words[at];
    if (!help.verbs.empty() && at == words.size() && !mayBeAlone) return "a verb is missing";
    if (verb == Words{"macula", "presets", "show"} || verb == Words{"macula", "presets", "export"}) {
        if (at < words.size())
            if (const std::string why = whyUnknown("--preset", words[at]); !why.empty()) return why;
    }
    std::set<std::string> given;
    for (; at < words.size(); ++at) {
        if (!words[at].starts_with("-") || words[at] == "-") continue;
        const std::string option = words[at].substr(0, words[at].find('='));
        const std::string value = at + 1 < words.size() ? words[at + 1] : "";
        if (const std::string why = whyWrong(option, value.starts_with("-") ? "" : value, help); !why.empty())
            return why;
        given.insert(option);
    }
    for (const std::string& names : help.required) {
        const Words any = splitAt(names, ',');
        if (isWhole &&
            std::ranges::none_of(any, [&](const std::string& name) { return given.contains(name); }))
            return names + " is missing";
    }
    return {};
}

}  // namespace macula::test
