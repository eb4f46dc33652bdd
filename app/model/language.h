#pragma once

#include <QLocale>
#include <QSet>
#include <QString>
#include <QStringList>
#include <QTranslator>

#include <memory>
#include <vector>

namespace app {

/// The language that the program speaks for as long as this lives; one at a time. What speaks it must be made after it.
class Language
{
public:
    /// The codes of the languages that the program has, in order of their names: "de", "en".
    static QStringList known();
    /// The first of `wanted` ("de-AT", "en") that the program has; English where it has none.
    static QString firstKnown(const QStringList &wanted);
    /// What the learner chose ("de"); where that is empty or unknown, what the system asks for.
    static QString chosen(const QString &code);
    /// What those who speak a language call it: "Deutsch".
    static QString nameOf(const QString &code);

    /// Speaks `code`, and writes the numbers on the screen as people do who speak it.
    explicit Language(const QString &code);
    Language(const Language &) = delete;
    Language &operator=(const Language &) = delete;
    ~Language();

    const QString &code() const { return m_code; }
    /// Adds the translations that have come since, with a plugin: its resources :/i18n/NAME_CODE.qm.
    void learn();

private:
    bool install(const QString &file);

    QString m_code;
    QLocale m_before;
    QSet<QString> m_learnt; ///< files
    std::vector<std::unique_ptr<QTranslator>> m_translators;
};

}
