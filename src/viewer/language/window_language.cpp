#include "viewer/language/window_language.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>
#include <string_view>
#include <variant>

namespace macula::viewer {

namespace {

// Appended by scene::ownCopy: " (edited)", from the second copy on " (edited 2)".
constexpr std::string_view kMarkOfCopy = " (edited";

std::string said(const Text& text);

std::string saidArgument(const TextArgument& argument, std::string_view spec) {
    if (const auto* text = std::get_if<Text>(&argument.value)) return said(*text);
    std::string words = englishOf(argument, spec);
    if (std::holds_alternative<double>(argument.value)) {
        if (const auto point = words.find('.'); point != std::string::npos)
            words.replace(point, 1, QLocale().decimalPoint().toStdString());
    }
    return words;
}

std::string said(const Text& text) {
    const QString format = QCoreApplication::translate("core", text.format().c_str());
    return filled(format.toStdString(), text.arguments(), saidArgument);
}

QString titleOf(const std::string& title) {
    return QCoreApplication::translate("titles", title.c_str());
}

// Where that mark begins; npos in titles without it, such as a person's own.
std::size_t markOfCopy(std::string_view title) {
    const std::size_t at = title.rfind(kMarkOfCopy);
    if (at == std::string_view::npos || at == 0 || !title.ends_with(')')) return std::string_view::npos;
    std::string_view number = title.substr(at + kMarkOfCopy.size());
    number.remove_suffix(1);
    const bool isOurs =
        number.empty() || (number.size() > 1 && number.front() == ' ' &&
                           number.find_first_not_of("0123456789", 1) == std::string_view::npos);
    return isOurs ? at : std::string_view::npos;
}

QString joined(const Text& first, const Text& second) {
    return inWindowsLanguage(Text::joined({first, second}, " "));
}

}  // namespace

QString inWindowsLanguage(const Text& text) {
    return QString::fromStdString(said(text));
}

QStringList inWindowsLanguage(const std::vector<Text>& texts) {
    QStringList all;
    for (const Text& text : texts) all << inWindowsLanguage(text);
    return all;
}

QString inWindowsLanguage(const Error& error) {
    return joined(error.message, error.hint);
}

QString inWindowsLanguage(const Message& message) {
    return joined(message.sentence, message.action);
}

QString titleInWindowsLanguage(const std::string& title) {
    const std::size_t mark = markOfCopy(title);
    if (mark == std::string::npos) return titleOf(title);
    return titleOf(title.substr(0, mark)) + QStringLiteral(" (") + titleOf("edited") +
           QString::fromStdString(title.substr(mark + kMarkOfCopy.size()));
}

QString withLocalNumbers(QString text) {
    const QString sign = QLocale().decimalPoint();
    if (sign == QLatin1String(".")) return text;
    static const QRegularExpression point(QStringLiteral("(?<=\\d)\\.(?=\\d)"));
    return text.replace(point, sign);
}

}  // namespace macula::viewer
