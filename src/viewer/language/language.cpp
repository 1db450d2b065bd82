#include "viewer/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <QTranslator>
#include <algorithm>

// Files in a static library are not registered by themselves; in no namespace, as Qt has it.
static void registerTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace macula::viewer {

namespace {

// Of the application, and gone with it.
QPointer<QTranslator> ofMacula;
QPointer<QTranslator> ofQt;

void remove(QPointer<QTranslator>& translator) {
    delete translator;  // which takes itself out of the application
    translator.clear();
}

// The desktop's own numbers, where they are of that language; 12.5 in English, 12,5 in German else.
QLocale localeOf(Language language) {
    const QLocale desktop = QLocale::system();
    const QLocale::Language wanted = language == Language::german ? QLocale::German : QLocale::English;
    return desktop.language() == wanted ? desktop : QLocale(wanted);
}

}  // namespace

std::optional<Language> languageOf(const QString& code) {
    const auto row = std::ranges::find_if(
        kLanguages, [&](const LanguageRow& each) { return code == QLatin1String(each.code); });
    return row == kLanguages.end() ? std::nullopt : std::optional(row->language);
}

QString codeOf(Language language) {
    return QString::fromLatin1(std::ranges::find(kLanguages, language, &LanguageRow::language)->code);
}

Language desktopLanguage() {
    for (const QString& name : QLocale::system().uiLanguages()) {
        if (const auto language = languageOf(name.left(2).toLower())) return *language;
    }
    return Language::english;
}

void useLanguage(Language language) {
    registerTranslations();
    remove(ofMacula);
    remove(ofQt);
    QLocale::setDefault(localeOf(language));
    const QString code = codeOf(language);
    QCoreApplication* application = QCoreApplication::instance();
    ofMacula = new QTranslator(application);  // of English: what is said of one, "1 picture"
    if (ofMacula->load(QStringLiteral(":/translations/macula_%1.qm").arg(code)))
        QCoreApplication::installTranslator(ofMacula);
    if (language == Language::english) return;  // else as the texts are written
    // Buttons of Qt's own dialogs; without the package that has them they stay in English.
    ofQt = new QTranslator(application);
    if (ofQt->load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(ofQt);
}

}  // namespace macula::viewer
