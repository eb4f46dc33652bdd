#pragma once

#include <QLocale>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <memory>
#include <vector>

namespace app {

/// The language of the program while this object exists. Only one may exist at a time. Create it before any object
/// that shows text.
class Language
{
public:
    /// Returns the codes of the available languages, sorted by language name: "de", "en", "es".
    static QStringList known();
    /// Returns the first of `wanted` ("de-AT", "en") that is available, or English if there is none.
    static QString firstKnown(const QStringList &wanted);
    /// Returns the language that the learner chose ("de"). If `code` is empty or unknown, returns the system's
    /// language.
    static QString chosen(const QString &code);
    /// Returns the name of a language in that language: "Deutsch".
    static QString nameOf(const QString &code);

    /// Installs the translations for `code`, and formats numbers on the screen in its usual way.
    explicit Language(const QString &code);
    Language(const Language &) = delete;
    Language &operator=(const Language &) = delete;
    ~Language();

    const QString &code() const { return m_code; }
    /// Installs translations that plugins have added since, from their resources :/i18n/NAME_CODE.qm.
    void learn();

private:
    bool install(const QString &file);

    QString m_code;
    QLocale m_before;
    QSet<QString> m_learnt; ///< files
    std::vector<std::unique_ptr<QTranslator>> m_translators;
};

}
