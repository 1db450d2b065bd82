#include "viewer/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QPointer>
#include <QTranslator>
#include <algorithm>

// Qt does not register resources of a static library automatically. In no namespace, as Q_INIT_RESOURCE
// demands.
static void registerTranslations() {
    Q_INIT_RESOURCE(translations);
}

namespace macula::viewer {

namespace {

// The application owns both, and destroys them.
QPointer<QTranslator> ofMacula;
QPointer<QTranslator> ofQt;

void remove(QPointer<QTranslator>& translator) {
    delete translator;  // its destructor removes it from the application
    translator.clear();
}

// The desktop's number format if it is of that language; otherwise 12.5 in English and 12,5 in German.
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
    ofMacula = new QTranslator(application);  // also for English: it has the singulars, "1 picture"
    if (ofMacula->load(QStringLiteral(":/translations/macula_%1.qm").arg(code)))
        QCoreApplication::installTranslator(ofMacula);
    if (language == Language::english) return;  // all other texts are English in the code
    // Translates the buttons of Qt's own dialogs; without Qt's package of translations they stay English.
    ofQt = new QTranslator(application);
    if (ofQt->load(QStringLiteral("qtbase_") + code, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(ofQt);
}

}  // namespace macula::viewer
