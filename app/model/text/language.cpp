#include "app/model/text/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>

#include <algorithm>

namespace app {

namespace {

const QString folder = QStringLiteral(":/i18n");

/// Returns the number format for `code`: the system's own, if the system uses that language.
QLocale localeFor(const QString &code)
{
    const QLocale system = QLocale::system();
    QLocale locale = system.name().section('_', 0, 0) == code ? system : QLocale(code);
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale;
}

}

QStringList Language::known()
{
    QStringList codes = {QStringLiteral("en")};
    for (const QString &file : QDir(folder).entryList({"app_*.qm"}, QDir::Files)) {
        const QString code = file.chopped(3).section('_', 1);
        if (!codes.contains(code))
            codes << code;
    }
    std::sort(codes.begin(), codes.end(),
              [](const QString &a, const QString &b) { return nameOf(a) < nameOf(b); });
    return codes;
}

QString Language::firstKnown(const QStringList &wanted)
{
    const QStringList codes = known();
    for (const QString &one : wanted) {
        const QString code = QString(one).replace('-', '_').section('_', 0, 0);
        if (codes.contains(code))
            return code;
    }
    return QStringLiteral("en");
}

QString Language::chosen(const QString &code)
{
    return known().contains(code) ? code : firstKnown(QLocale::system().uiLanguages());
}

QString Language::nameOf(const QString &code)
{
    // QLocale says "American English" and "español de España", which is too specific.
    const QString name = code == "en" ? QStringLiteral("English") : QLocale(code).nativeLanguageName();
    return name.left(1).toUpper() + name.mid(1).section(' ', 0, 0);
}

Language::Language(const QString &code) : m_code(code)
{
    QLocale::setDefault(localeFor(code));
    install(QLibraryInfo::path(QLibraryInfo::TranslationsPath) + "/qtbase_" + code + ".qm");
    learn();
}

Language::~Language()
{
    for (const auto &translator : m_translators)
        QCoreApplication::removeTranslator(translator.get());
    QLocale::setDefault(m_before);
}

void Language::learn()
{
    for (const QString &file : QDir(folder).entryList({"*_" + m_code + ".qm"}, QDir::Files)) {
        if (!m_learnt.contains(file) && install(folder + '/' + file))
            m_learnt.insert(file);
    }
}

bool Language::install(const QString &file)
{
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(file))
        return false;
    QCoreApplication::installTranslator(translator.get());
    m_translators.push_back(std::move(translator));
    return true;
}

}
