// The language that the window speaks.
#pragma once

#include <QString>
#include <array>
#include <optional>

namespace macula::viewer {

enum class Language { english, german };

struct LanguageRow {
    Language language;
    const char* code;   // ISO 639-1, as options and settings write it
    const char* title;  // in the language itself: who cannot read the others finds it
};
inline constexpr std::array kLanguages{LanguageRow{Language::english, "en", "English"},
                                       LanguageRow{Language::german, "de", "Deutsch"}};

// Nothing for a language that there is not.
std::optional<Language> languageOf(const QString& code);
QString codeOf(Language language);

// The first of those that the desktop asks for; English where there is none of them.
Language desktopLanguage();

// Texts, and how numbers are written, from now on: widgets that are there already keep theirs, so it comes
// before them. May be called again. On the UI thread; needs a QCoreApplication.
void useLanguage(Language language);

}  // namespace macula::viewer
