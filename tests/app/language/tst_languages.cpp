// The languages of the window: everything is translated, and the language is the chosen one or the system's.

#include "app/model/learning/project_start.h"
#include "app/model/sandbox/sandbox_properties.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"
#include "app/ui/dialogs/notice.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/pipeline.h"
#include "sim/scene/blueprint.h"
#include "tests/app/language/translated_window.h"
#include "tests/suite.h"

#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QSettings>
#include <QtTest>

using namespace app;
using namespace tests;

namespace {

void collectMenus(const QMenu *menu, QList<const QMenu *> &all)
{
    all << menu;
    for (const QAction *action : menu->actions()) {
        if (action->menu())
            collectMenus(action->menu(), all);
    }
}

/// Returns the mnemonics that two entries of `actions` share.
QStringList sharedLetters(const QList<QAction *> &actions)
{
    QStringList shared;
    QHash<QChar, QString> seen;
    for (const QAction *action : actions) {
        const qsizetype at = action->text().indexOf(QRegularExpression("&\\w"));
        if (at < 0)
            continue;
        const QChar letter = action->text()[at + 1].toLower();
        if (seen.contains(letter))
            shared << seen[letter] + " / " + action->text();
        seen[letter] = action->text();
    }
    return shared;
}

/// The texts of sim in a run that have no German.
void missIn(const sim::Scene &scene, const sim::Method &method, QSet<QString> &missing)
{
    const auto look = [&](const std::string &text) {
        // Languages share some words of the same spelling, so the question is whether there is an entry.
        const QString said = QString::fromStdString(text);
        static const QSet<QString> same = {"Motor", "Wind", "Anticipation", "Points", "Branches"};
        if (!text.empty() && phrase(text) == said && said.size() > 1 && !same.contains(capitalised(said)))
            missing.insert(said);
    };
    for (const auto &group : scene.groups)
        look(group.title);
    for (const auto &phase : sim::compose(scene, method, sim::stepFor(method, {})).phases)
        look(phase.title);
}

}

class LanguagesTest : public QObject
{
    Q_OBJECT

private slots:
    void languagesAreNamedInTheirOwnWords();
    void firstKnownLanguageOfTheSystemIsChosen_data();
    void firstKnownLanguageOfTheSystemIsChosen();
    void numbersHaveACommaOnTheScreen();
    void everyStepIsTranslated_data() { addTranslatedLanguages(); }
    void everyStepIsTranslated();
    void namesFromTheSimulationAreTranslated_data() { addTranslatedLanguages(); }
    void namesFromTheSimulationAreTranslated();
    void bodiesOfProjectsAreTranslated_data() { addTranslatedLanguages(); }
    void bodiesOfProjectsAreTranslated();
    void sectionsOfPropertiesUseTheNamesOfThePicture();
    void noLetterOpensTwoEntriesOfAMenu_data();
    void noLetterOpensTwoEntriesOfAMenu();
    void choosingTheCurrentLanguageOpensNoNewWindow();
    void theChoiceOfALanguageIsRemembered();
};

void LanguagesTest::languagesAreNamedInTheirOwnWords()
{
    QCOMPARE(Language::known(), QStringList({"de", "en", "es", "fr"}));
    QCOMPARE(Language::nameOf("de"), QString("Deutsch"));
    QCOMPARE(Language::nameOf("en"), QString("English"));
    QCOMPARE(Language::nameOf("es"), QString("Español"));
    QCOMPARE(Language::nameOf("fr"), QString("Français"));
}

void LanguagesTest::firstKnownLanguageOfTheSystemIsChosen_data()
{
    QTest::addColumn<QStringList>("wanted");
    QTest::addColumn<QString>("spoken");
    QTest::newRow("German") << QStringList{"de-DE"} << "de";
    QTest::newRow("German of Austria") << QStringList{"de-Latn-AT", "de-AT", "de"} << "de";
    QTest::newRow("Spanish of Mexico") << QStringList{"es-Latn-MX", "es-MX", "es"} << "es";
    QTest::newRow("none of them") << QStringList{"it-IT"} << "en";
    QTest::newRow("the second") << QStringList{"it", "fr"} << "fr";
    QTest::newRow("English first") << QStringList{"en-GB", "de"} << "en";
    QTest::newRow("C") << QStringList{"C"} << "en";
}

void LanguagesTest::firstKnownLanguageOfTheSystemIsChosen()
{
    QFETCH(QStringList, wanted);
    QTEST(Language::firstKnown(wanted), "spoken");
}

void LanguagesTest::numbersHaveACommaOnTheScreen()
{
    {
        const Language german("de");
        QCOMPARE(fixedNumber(-1234.5, 2), QString("−1234,50"));
        QCOMPARE(roughNumber(2.1e-11), QString("2,1·10⁻¹¹"));
        QCOMPARE(writtenNumber(0.25, 1), QString("0,25"));
    }
    const Language english("en");
    QCOMPARE(fixedNumber(-1234.5, 2), QString("−1234.50"));
}

void LanguagesTest::everyStepIsTranslated()
{
    QFETCH(QString, language);
    const LessonLibrary english = LessonLibrary::load({LESSON_DIR});
    Language spoken(language);
    const LessonLibrary translated = LessonLibrary::load({LESSON_DIR}, &spoken);
    QCOMPARE(translated.lessons.size(), english.lessons.size());
    for (std::size_t i = 0; i < translated.lessons.size(); ++i) {
        const LessonEntry &lesson = translated.lessons[i];
        QVERIFY2(lesson.summary != english.lessons[i].summary, qPrintable(lesson.id));
        for (std::size_t s = 0; s < lesson.steps.size(); ++s) {
            const lessons::Step &said = lesson.steps[s], &was = english.lessons[i].steps[s];
            const QString name = lesson.id + '/' + said.id;
            QVERIFY2(said.narration != was.narration, qPrintable(name));
            for (std::size_t t = 0; t < said.tries.size(); ++t)
                QVERIFY2(said.tries[t].text != was.tries[t].text, qPrintable(name));
            for (std::size_t p = 0; p < said.parameters.size(); ++p)
                QVERIFY2(said.parameters[p].help != was.parameters[p].help, qPrintable(name));
        }
    }
}

void LanguagesTest::namesFromTheSimulationAreTranslated()
{
    QFETCH(QString, language);
    Language spoken(language);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR}, &spoken);
    QSet<QString> missing;
    for (const LessonEntry &lesson : library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            const sim::Scene scene = step.scene(step.defaultValues());
            for (const sim::MethodPtr &method : sim::allMethods()) {
                try {
                    missIn(scene, *method, missing);
                } catch (const sim::Error &) { // not every method fits every scene
                }
            }
            for (const std::string &name : scene.names) {
                const QString title = bodyTitle(QString::fromStdString(name));
                if (title.contains(
                        QRegularExpression("\\b(foot|body|creature|lead|tail|side|tentacle|branch)\\b")))
                    missing.insert(title);
            }
        }
    }
    QVERIFY2(missing.isEmpty(), qPrintable(missing.values().join(" | ")));
}

void LanguagesTest::bodiesOfProjectsAreTranslated()
{
    QFETCH(QString, language);
    Language spoken(language);
    const LessonLibrary library = LessonLibrary::load({LESSON_DIR}, &spoken);
    int bodies = 0;
    for (const LessonEntry &lesson : library.lessons) {
        if (!lesson.project)
            continue;
        const Experiment start = projectStart(lesson, library);
        if (!start.script.values.blueprint)
            continue;
        for (const sim::BlueprintPoint &point : start.script.values.blueprint->points) {
            const QString name = QString::fromStdString(point.name), title = bodyTitle(name);
            static const QRegularExpression word(QStringLiteral("[a-z]{2,}"));
            for (auto words = word.globalMatch(name); words.hasNext(); ++bodies) {
                const QString one = words.next().captured();
                QVERIFY2(!QRegularExpression("\\b" + one + "\\b").match(title).hasMatch(), qPrintable(title));
            }
        }
    }
    QVERIFY(bodies > 20);
}

void LanguagesTest::sectionsOfPropertiesUseTheNamesOfThePicture()
{
    const TranslatedWindow german("de");
    sim::Blueprint plan;
    for (const char *name : {"body", "foot1"})
        plan.points.emplace_back().name = name;
    plan.gaits = {{}};
    plan.feet = {{1, 0}};
    Selection chosen;
    chosen.points = {1};
    QStringList sections;
    for (const SandboxProperty &one : propertiesOf(plan, chosen))
        sections << one.section;
    sections.removeDuplicates();
    QCOMPARE(sections, QStringList({"Punkt Fuß 1", "Fuß von Körper", "Ganggruppe 0"}));
}

void LanguagesTest::noLetterOpensTwoEntriesOfAMenu_data()
{
    QTest::addColumn<QString>("language");
    for (const QString &code : Language::known())
        QTest::newRow(qPrintable(code)) << code;
}

void LanguagesTest::noLetterOpensTwoEntriesOfAMenu()
{
    QFETCH(QString, language);
    TranslatedWindow shown(language);
    const auto *bar = shown.window.findChild<QMenuBar *>();
    QList<const QMenu *> menus;
    for (const QAction *action : bar->actions())
        collectMenus(action->menu(), menus);
    QStringList shared = sharedLetters(bar->actions());
    for (const QMenu *menu : menus)
        shared << sharedLetters(menu->actions());
    QVERIFY2(shared.isEmpty(), qPrintable(shared.join('\n')));
}

void LanguagesTest::choosingTheCurrentLanguageOpensNoNewWindow()
{
    QSettings().setValue("window/language", "de");
    TranslatedWindow german("de");
    auto *menu = german.window.findChild<QMenu *>("language");
    QVERIFY(menu);
    menu->actions().at(2)->trigger(); // Deutsch
    QVERIFY(german.window.isVisible());
    QVERIFY(german.window.findChild<Notice *>()->sentence().isEmpty());
    QSettings().remove("window/language");
}

void LanguagesTest::theChoiceOfALanguageIsRemembered()
{
    QSettings().setValue("window/language", "de");
    TranslatedWindow german("de");
    auto *menu = german.window.findChild<QMenu *>("language");
    QVERIFY(menu);
    QStringList entries;
    for (QAction *action : menu->actions()) {
        entries << action->text();
        if (action->text() == "English")
            action->trigger();
    }
    QCOMPARE(entries, QStringList({"&Systemsprache", "", "Deutsch", "English", "Español", "Français"}));
    QCOMPARE(QSettings().value("window/language").toString(), QString("en"));
    QCOMPARE(Language::chosen("en"), QString("en"));
    QVERIFY2(german.window.isHidden(), "another language did not ask for a new window");
    QSettings().remove("window/language");
}

SUITE(tst_languages, LanguagesTest)
#include "tst_languages.moc"
