#include "app/cli/option_values.h"

#include "app/model/text/language.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace app {

namespace {

struct OptionValuesText
{
    Q_DECLARE_TR_FUNCTIONS(OptionValuesText)
};

}

double numberOption(const Arguments &arguments, const QString &option, double least, double most)
{
    const QString text = arguments.value(option);
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    if (!isNumber || !(number >= least && number <= most)) // true for NaN, too
        throw UsageError(OptionValuesText::tr("--%1 is %2; it can be %3 to %4.")
                             .arg(option, quoted(text), exactNumber(least), exactNumber(most)));
    return number;
}

std::int64_t wholeNumberOption(const Arguments &arguments, const QString &option, std::int64_t most)
{
    const QString text = arguments.value(option);
    bool isNumber = false;
    const qint64 number = text.toLongLong(&isNumber);
    if (!isNumber || number < 0 || number > most)
        throw UsageError(OptionValuesText::tr("--%1 is %2; it can be a whole number from 0 to %3.")
                             .arg(option, quoted(text))
                             .arg(most));
    return number;
}

QSize pictureSize(const Arguments &arguments)
{
    static const QRegularExpression form(QStringLiteral("\\A(\\d{3,4})x(\\d{3,4})\\z"));
    const QString text = arguments.value("size");
    const auto match = form.match(text);
    if (!match.hasMatch())
        throw UsageError(
            OptionValuesText::tr(
                "--size is %1; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.")
                .arg(quoted(text)));
    return {match.captured(1).toInt(), match.captured(2).toInt()};
}

Scheme colorScheme(const Arguments &arguments)
{
    const QString text = arguments.value("theme");
    if (text == "light")
        return Scheme::light;
    if (text == "dark")
        return Scheme::dark;
    if (text == "contrast")
        return Scheme::highContrast;
    throw UsageError(OptionValuesText::tr("--theme is %1; it can be \"light\", \"dark\" or \"contrast\".")
                         .arg(quoted(text)));
}

QString languageCode(const Arguments &arguments)
{
    if (!arguments.has("language"))
        return Language::chosen({});
    const QString code = arguments.value("language");
    if (!Language::known().contains(code))
        throw UsageError(OptionValuesText::tr("--language is %1; it can be %2.")
                             .arg(quoted(code), Language::known().join(QStringLiteral(", "))));
    return code;
}

}
