// The language of the window.
#pragma once

#include <QString>
#include <array>
#include <optional>

namespace macula::viewer {

enum class Language { english, german };

struct LanguageRow {
    Language language;
    const char* code;   // ISO 639-1, as options and settings write it
    const char* title;  // in that language, for people who read no other
};
inline constexpr std::array kLanguages{LanguageRow{Language::english, "en", "English"},
                                       LanguageRow{Language::german, "de", "Deutsch"}};

// Nothing for an unknown code.
std::optional<Language> languageOf(const QString& code);
QString codeOf(Language language);

// The first language that the desktop asks for and kLanguages has; else English.
Language desktopLanguage();

// Sets the language of texts and numbers. Existing widgets keep theirs, so call it before making them. May be
// called again. On the UI thread; needs a QCoreApplication.
void useLanguage(Language language);

}  // namespace macula::viewer
